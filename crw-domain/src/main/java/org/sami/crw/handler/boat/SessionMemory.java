package org.sami.crw.handler.boat;

import java.util.Optional;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.TextValue;

/** What the base remembers of a robot in the session's journal, across its own restarts. From any thread. */
public enum SessionMemory {
    /** Which start of its server was met last and may be moved. */
    BOOT("boot/"),
    /** The class of its battery that was news last. */
    BATTERY("battery/"),
    /** The waypoint list that was sent to it last and that it took. */
    LIST("list/"),
    /** The base that wishes to command it, while the operator is asked; empty text for none. */
    ASKER("asker/"),
    /** Who has taken the boat over from the missions, as last reported to plans; empty text for none. */
    TAKEN_OVER("taken-over/"),
    /** Whether its link was lost, as last reported to plans of aircraft. */
    LINK("link/"),
    /** The missions that keep it for themselves, the newest last; empty text for none. */
    BLOCKS("blocks/");

    private final String prefix;

    SessionMemory(String prefix) {
        this.prefix = prefix;
    }

    /** What was remembered of one last; empty where nothing was. */
    public Optional<String> of(String boatId, EngineHost host) {
        return host.ask(view -> of(boatId, view));
    }

    /** The same in a state of the engine. */
    public Optional<String> of(String boatId, EngineView view) {
        return view.memory(Ids.NONE, prefix + boatId)
                .filter(TextValue.class::isInstance)
                .map(value -> ((TextValue) value).value());
    }

    /** What has it remembered. */
    public Input remember(String boatId, String what) {
        return new Input.Remember(Ids.NONE, prefix + boatId, new TextValue(what));
    }
}
