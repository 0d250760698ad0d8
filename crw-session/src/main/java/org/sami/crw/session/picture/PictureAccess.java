package org.sami.crw.session.picture;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.sami.crw.proxy.file.BoatFileFetch.NamedFiles;

/** A way to the pictures that one boat keeps. */
public interface PictureAccess {
    /**
     * Fetches pictures by their names into a folder, each of which comes or is missed. Waits for the boat, so not for the fleet's thread. What has come of a picture by an earlier
     * call is not fetched again.
     *
     * @throws org.sami.crw.proxy.file.FileFetchException if the boat gives none
     * @throws IOException if the boat is not reached, or this was cancelled: the rest may come later
     */
    void fetch(List<String> names, Path folder, NamedFiles result) throws IOException;

    /** Ends a fetch soon; from any thread. */
    void cancel();
}
