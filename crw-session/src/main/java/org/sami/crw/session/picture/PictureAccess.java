package org.sami.crw.session.picture;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.sami.crw.proxy.file.BoatFileFetch.NamedFiles;

/** A way to the pictures that one boat keeps. */
public interface PictureAccess {
    /**
     * Fetches pictures by their names into a folder, and reports each as fetched or missed. Blocks until the boat has answered, so it must not be called on the
     * fleet's thread. Parts of a picture that an earlier call has fetched are not fetched again.
     *
     * @throws org.sami.crw.proxy.file.FileFetchException if the boat gives none
     * @throws IOException if the boat is not reached, or this was cancelled: the rest may come later
     */
    void fetch(List<String> names, Path folder, NamedFiles result) throws IOException;

    /** Ends a fetch soon; from any thread. */
    void cancel();
}
