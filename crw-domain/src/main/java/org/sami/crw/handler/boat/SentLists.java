package org.sami.crw.handler.boat;

import java.util.HashSet;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;

/**
 * Keeps in the session's journal which waypoint list each boat took last, so that a base that goes on after its death knows its own
 * list in the boat, and has the boat go on with it (docs/link.md). For the fleet's thread.
 */
public final class SentLists implements Consumer<FleetEvent> {
    private final EngineHost host;
    private final ProxyRegistry boats;
    private final Set<String> met = new HashSet<>();

    public SentLists(EngineHost host, ProxyRegistry boats) {
        this.host = host;
        this.boats = boats;
    }

    /** Whether the list that a boat took last is that of a command. */
    public static boolean isOf(String commandId, String boatId, EngineView view) {
        return SessionMemory.LIST
                .of(boatId, view)
                .filter(listId -> listId.startsWith(commandId + "#"))
                .isPresent();
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.LinkChanged link) {
            onLinkChange(link.status());
        } else if (event instanceof FleetEvent.UploadAdvanced advanced) {
            onUpload(advanced.boat(), advanced.upload());
        }
    }

    private void onLinkChange(BoatStatus status) {
        if (status.link() == LinkState.LINKED && met.add(status.boatId())) {
            SessionMemory.LIST
                    .of(status.boatId(), host)
                    .ifPresent(listId -> boats.find(status.boatId())
                            .ifPresent(proxy -> proxy.commands().knownList(listId)));
        }
    }

    /** Before it is started: what the boat drives along must be known. */
    private void onUpload(String boatId, Upload upload) {
        if (upload.state() == Upload.State.ACKNOWLEDGED) {
            met.add(boatId);
            host.post(SessionMemory.LIST.remember(boatId, upload.listId()));
        }
    }
}
