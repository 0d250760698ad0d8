package org.sami.boat.hull.stream;

/** Receives what a {@link ReconnectingPort} reads and how the port is; called on the port's thread. */
public interface PortListener {
    /** The port is open. */
    void opened();

    /** A line has come. */
    void line(String line);

    /** The port is gone, or could not be opened again; said once for each loss, and once more where the reason is another. */
    void lost(String why);
}
