package org.sami.dreamm.file;

import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/** Why a file or folder could not be written, in words for people: the system names the file and often nothing else. */
final class SaveFault {
    private SaveFault() {}

    /**
     * The cause, without the file's own name.
     *
     * @param path what was to be written
     */
    static String words(Path path, Exception fault) {
        Throwable cause = fault.getCause() instanceof FileSystemException ? fault.getCause() : fault;
        String folder = String.valueOf(path.toAbsolutePath().normalize().getParent());
        if (cause instanceof NoSuchFileException) {
            return "there is no folder " + folder;
        }
        if (cause instanceof AccessDeniedException) {
            return "you have no permission to write in " + folder;
        }
        if (cause instanceof FileAlreadyExistsException there && Files.isRegularFile(Path.of(there.getFile()))) {
            return there.getFile() + " is a file and no folder";
        }
        if (cause instanceof FileSystemException system && system.getReason() != null) {
            return system.getReason() + " (" + system.getFile() + ")";
        }
        return cause.getMessage() == null ? cause.toString() : cause.getMessage();
    }
}
