package org.sami.crw.handler.boat;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.host.EngineHost;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.TextValue;

/**
 * Reports to plans when a person or another base takes a boat over, and when it is back: once each, also across a restart of the base, which ends
 * driving by hand. For the fleet's thread.
 */
public final class TakeOverNews implements Consumer<FleetEvent> {
    private static final String BY_HAND = "operator";
    private static final String BY_OTHERS = "another base";

    private final EngineHost host;
    private final ProxyRegistry boats;
    private final Set<String> byHand = new HashSet<>();
    private final Set<String> byOthers = new HashSet<>();
    // by boat, who has it as plans know; begins with the session's memory
    private final Map<String, String> told = new HashMap<>();

    public TakeOverNews(EngineHost host, ProxyRegistry boats) {
        this.host = host;
        this.boats = boats;
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.TakenOver taken) {
            onTakenOver(taken.boat());
        } else if (event instanceof FleetEvent.HandedBack back) {
            onReleased(back.boat());
        } else if (event instanceof FleetEvent.CommanderChanged commander) {
            onCommanding(commander.boat(), commander.commands());
        } else if (event instanceof FleetEvent.LinkChanged link) {
            onLinkChange(link.status());
        } else if (event instanceof FleetEvent.Retired retired) {
            onRetired(retired.boat());
        }
    }

    private void onTakenOver(String boatId) {
        byHand.add(boatId);
        tell(boatId);
    }

    private void onReleased(String boatId) {
        byHand.remove(boatId);
        tell(boatId);
    }

    private void onCommanding(String boatId, boolean commands) {
        hasOther(boatId, !commands);
        tell(boatId);
    }

    /** When this base met the boat, another may have commanded it: then nothing has changed hands. */
    private void onLinkChange(BoatStatus status) {
        if (status.link() == LinkState.LINKED) {
            boats.find(status.boatId()).ifPresent(proxy -> {
                hasOther(proxy.boatId(), !proxy.isCommanding());
                tell(proxy.boatId());
            });
        }
    }

    private void hasOther(String boatId, boolean has) {
        if (has) {
            byOthers.add(boatId);
        } else {
            byOthers.remove(boatId);
        }
    }

    private void onRetired(String boatId) {
        byHand.remove(boatId);
        byOthers.remove(boatId);
        if (!told(boatId).isEmpty()) {
            told.put(boatId, "");
            host.post(SessionMemory.TAKEN_OVER.remember(boatId, ""));
        }
    }

    private String told(String boatId) {
        return told.computeIfAbsent(
                boatId, id -> SessionMemory.TAKEN_OVER.of(id, host).orElse(""));
    }

    private void tell(String boatId) {
        String by = byHand.contains(boatId) ? BY_HAND : byOthers.contains(boatId) ? BY_OTHERS : "";
        if (by.isEmpty() == told(boatId).isEmpty()) {
            return;
        }
        told.put(boatId, by);
        Occurrence news = by.isEmpty()
                ? Occurrence.news(EventNames.RELEASED, List.of(boatId), Map.of())
                : Occurrence.news(EventNames.TAKEN_OVER, List.of(boatId), Map.of("by", new TextValue(by)));
        host.post(List.of(SessionMemory.TAKEN_OVER.remember(boatId, by), new Input.Received(news)));
    }
}
