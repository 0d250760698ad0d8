package org.sami.boat.server;

import java.util.function.Consumer;
import org.sami.boat.link.FileAnswer;
import org.sami.boat.link.FileRefusal;
import org.sami.boat.link.FileRequest;

/** Where a boat's server gets the files that clients ask for. It is asked on the thread that drives the boat, and must not read a disk there. */
public interface FileProvider {
    /** Of a boat that keeps no files. */
    FileProvider NONE = (request, answer) -> answer.accept(
            new FileRefusal(request.requestId(), FileRefusal.Reason.NO_FILES, "this boat keeps no files"));

    /**
     * Takes a request.
     *
     * @param answer to be called once, on the thread that drives the boat, at any time
     */
    void asked(FileRequest request, Consumer<FileAnswer> answer);
}
