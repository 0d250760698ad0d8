package org.sami.crw.proxy.file;

import java.io.Closeable;
import java.io.IOException;
import java.util.List;
import org.sami.boat.link.KeptFile;

/**
 * The files that one boat keeps, over one link to it: the boat's own, or one through a base elsewhere. All calls wait for the boat, until the link breaks or is closed; for one thread, but {@link #close} for any.
 */
public interface BoatFileSource extends Closeable {
    /**
     * Makes the link; once, before all else.
     *
     * @throws FileFetchException if trying again at once does not help
     * @throws IOException if the boat is not reached
     */
    void open() throws IOException;

    /** The boat that answers. */
    String boatId();

    /**
     * All files of a kind, such as {@link KeptFile#LOG}.
     *
     * @throws FileFetchException if the boat lists none
     * @throws IOException if the link breaks
     */
    List<KeptFile> list(String kind) throws IOException;

    /**
     * The bytes of a file from an offset on, as many as come at once: none at the end of the file, at most {@code atMost}.
     *
     * @throws FileFetchException if the boat gives none
     * @throws IOException if the link breaks
     */
    byte[] piece(String name, long offset, int atMost) throws IOException;
}
