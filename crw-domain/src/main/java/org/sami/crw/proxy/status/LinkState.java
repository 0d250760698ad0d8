package org.sami.crw.proxy.status;

/** What a proxy knows of the link to its boat. */
public enum LinkState {
    /** The boat has not answered yet. */
    CONNECTING,
    /** The boat answers. */
    LINKED,
    /** Nothing has come from the boat for the configured time, or its link has closed. */
    LOST
}
