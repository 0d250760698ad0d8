package org.sami.crw.gui.context;

import java.util.Optional;
import org.sami.crw.fleet.RobotKind;
import org.sami.ui.command.Command;

/**
 * What a window does with things that only the session's own machine has: its keys, its networks, its files. A window over a session elsewhere shows these commands too, and says of each what
 * to do instead.
 */
public enum MachineCommand {
    /** Lists boats that announce themselves. */
    BOATS_NEAR(
            "boats-near",
            "Boats near…",
            "ctrl N",
            "search",
            "boats are looked for on the networks of the session's machine; connect a boat by its address (Ctrl+B)"),
    /** Pairs a boat with the base. */
    PAIR("boat-pair", "Pair a boat…", "alt shift P", "link", Reasons.KEYS + "pair there: crw keys pair HOST:PORT"),
    /** Shows a code to a phone. */
    PHONE("phone-add", "Add a phone…", "alt shift A", "plus", Reasons.KEYS + "pair there: crw keys pair HOST:PORT"),
    /** Lists the base's keys. */
    KEYS("keys", "Keys…", "alt shift K", "variables", Reasons.KEYS + "list them there: crw keys list"),
    /** Passes simulated boats on. */
    GROUND_STATION(
            "boats-ground-station",
            "Show simulated boats to a ground station…",
            "alt shift G",
            "link",
            "this window has no simulated boats; a boat shows itself to a ground station: crw boat --mavlink ADDRESS"),
    /** Reads other plans. */
    PROJECT(
            "project-open",
            "Load a project…",
            "ctrl O",
            "folder",
            "the session runs in another process, with the project that crw serve was started with"),
    /** Chooses what boats do while the engine is broken. */
    BOATS_AT_FAULT(
            "fault-boats",
            "On a fault of the engine: boats hold, or all stop",
            "ctrl shift F11",
            "health",
            "the session runs in another process; it is chosen there: crw serve --on-fault");

    /** Beginnings of reasons. */
    private static final class Reasons {
        static final String KEYS = "keys of boats are on the session's machine; ";
    }

    private final String id;
    private final String title;
    private final String key;
    private final String icon;
    private final String elsewhere;

    MachineCommand(String id, String title, String key, String icon, String elsewhere) {
        this.id = id;
        this.title = title;
        this.key = key;
        this.icon = icon;
        this.elsewhere = elsewhere;
    }

    /** Whether it is of use where plans command robots of a kind: the app for phones, and what ground stations are shown, are of boats. */
    public boolean isFor(RobotKind robots) {
        return robots != RobotKind.COPTER || (this != PHONE && this != GROUND_STATION);
    }

    /** The command in the session's own window. */
    public Command here(Runnable run) {
        return new Command(id, title, run).withKey(key).withIcon(icon);
    }

    /** The command in a window over a session elsewhere: it cannot be run, and says why. */
    public Command elsewhere() {
        return here(() -> {}).unless(() -> Optional.of(elsewhere));
    }
}
