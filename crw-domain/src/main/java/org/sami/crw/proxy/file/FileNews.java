package org.sami.crw.proxy.file;

import java.net.InetSocketAddress;

/** Receives how the fetching of one boat's files goes, on the thread that fetches; does not wait. */
public interface FileNews {
    /** Nobody. */
    FileNews NONE = (boatId, name, here, bytes) -> {};

    /**
     * So much of a file is here.
     *
     * @param boatId the boat
     * @param name of the file
     * @param here bytes that are here
     * @param bytes of the whole file
     */
    void come(String boatId, String name, long here, long bytes);

    /**
     * The boat does not answer; it is tried again.
     *
     * @param address of the boat
     * @param why in words
     */
    default void waits(InetSocketAddress address, String why) {}
}
