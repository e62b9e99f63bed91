# The file system of the card, for every target that has one. It allocates nothing, has no assertions (errors
# are found by error codes and the CRC of a record) and logs nothing. The names of our files are short.

littlefs_folder := third_party/littlefs
littlefs_sources := $(addprefix $(littlefs_folder)/,lfs.c lfs_util.c)
littlefs_flags := -DLFS_NO_MALLOC -DLFS_NO_ASSERT -DLFS_NO_DEBUG -DLFS_NO_WARN -DLFS_NO_ERROR -DLFS_NAME_MAX=31 \
  -isystem $(littlefs_folder)
