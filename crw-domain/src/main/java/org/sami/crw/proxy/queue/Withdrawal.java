package org.sami.crw.proxy.queue;

/** Why a command left the queue undone without its mission asking for it. */
public enum Withdrawal {
    /** A newer command of the same mission for the same boat took its place. */
    SUPERSEDED,
    /** A command of higher priority took the boat while it ran. */
    PREEMPTED
}
