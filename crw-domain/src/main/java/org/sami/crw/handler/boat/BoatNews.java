package org.sami.crw.handler.boat;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.handler.subscription.BatterySubscriptions;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.link.LinkAlarm;
import org.sami.crw.proxy.link.LinkLosses;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.engine.MissionView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.RealValue;

/**
 * What boats report, as news to plans and messages to the operator. A boat joins when its link is up for the first time. Poses
 * become inputs only while a transition waits for them; a battery is news when its class changes. For the fleet's
 * thread.
 */
public final class BoatNews implements Consumer<FleetEvent> {
    private static final int MOST_FAULTS = 100;

    private final EngineHost host;
    private final NewBoats newBoats;
    private final MessageSink messages;
    private final BatterySubscriptions batteries;
    private final Set<String> joined = new HashSet<>();
    private final Set<String> observed = new HashSet<>();
    private final Map<String, String> levels = new HashMap<>();
    private final Set<String> faults = new HashSet<>();
    private final Map<String, LinkLosses> links = new HashMap<>();

    public BoatNews(EngineHost host, NewBoats newBoats, MessageSink messages, BatterySubscriptions batteries) {
        this.batteries = batteries;
        this.host = host;
        this.newBoats = newBoats;
        this.messages = messages;
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.StatusReported reported) {
            onStatus(reported.status());
        } else if (event instanceof FleetEvent.LinkChanged link) {
            onLinkChange(link.status());
        } else if (event instanceof FleetEvent.BatteryReported battery) {
            onBattery(battery.boat(), battery.battery());
        } else if (event instanceof FleetEvent.Retired retired) {
            onRetired(retired.boat());
        } else if (event instanceof FleetEvent.Restarted restarted) {
            onRestarted(restarted.status());
        } else if (event instanceof FleetEvent.CommanderChanged commander) {
            onCommanding(commander);
        } else if (event instanceof FleetEvent.PlaceHeld held) {
            onHoldsPlace(held.boat(), held.givenUp());
        } else if (event instanceof FleetEvent.Refused refused) {
            onRefused(refused.boat(), refused.reason());
        } else if (event instanceof FleetEvent.ReleaseDropped dropped) {
            onReleaseDropped(dropped.boat(), dropped.reason());
        } else if (event instanceof FleetEvent.LinkAlarmed alarmed
                && alarmed.alarm().kind() == LinkAlarm.Kind.SAID_BY_BOAT) {
            onSaid(alarmed.alarm());
        } else if (event instanceof FleetEvent.ListenerFault fault) {
            onListenerFault(fault.listener(), fault.cause());
        }
    }

    private void onStatus(BoatStatus status) {
        host.postIfAwaited(Occurrence.news(EventNames.POSE_UPDATED, List.of(status.boatId()), Map.of()));
    }

    private void onLinkChange(BoatStatus status) {
        String boat = status.boatId();
        LinkLosses losses = links.computeIfAbsent(boat, id -> new LinkLosses());
        long now = host.nowMillis();
        if (status.link() == LinkState.LOST) {
            losses.lost(now);
            String again = losses.count(now) > 1 ? " again, " + losses.words(now) : "";
            tell(boat, Priority.MEDIUM, "The link to " + boat + " is lost" + again + "; its commands wait");
        } else if (status.link() == LinkState.LINKED && !joined.add(boat)) {
            losses.back();
            String often = losses.count(now) > 1 ? "; it was lost " + losses.words(now) : "";
            tell(boat, Priority.LOW, "The link to " + boat + " is back" + often);
        } else if (status.link() == LinkState.LINKED
                && !host.ask(view -> view.proxies().contains(boat))) {
            host.post(newBoats.joined(boat, host.ask(view -> view.awaits(EventNames.PROXY_CREATED))));
        }
    }

    private void onBattery(String boatId, BatteryState battery) {
        String level = battery.level().name();
        Optional<String> before = Optional.ofNullable(levels.put(boatId, level));
        if (!before.or(() -> SessionMemory.BATTERY.of(boatId, host)).equals(Optional.of(level))) {
            List<Input> inputs = new ArrayList<>(List.of(SessionMemory.BATTERY.remember(boatId, level)));
            for (long mission : missionsWithoutSubscription(boatId)) {
                inputs.add(new Input.Received(new Occurrence(
                        EventNames.of(battery.level()),
                        mission,
                        Ids.NONE,
                        List.of(boatId),
                        List.of(),
                        Map.of("percent", new RealValue(battery.percent())))));
            }
            host.post(inputs);
        }
    }

    /** Whom the boat's own classes concern: nobody in particular, unless a mission has subscribed with thresholds of its own. */
    private List<Long> missionsWithoutSubscription(String boatId) {
        Set<Long> subscribers = batteries.subscribers(boatId);
        return subscribers.isEmpty()
                ? List.of(Ids.NONE)
                : host.ask(view -> view.missions().stream()
                        .map(MissionView::id)
                        .filter(mission -> !subscribers.contains(mission))
                        .toList());
    }

    /** If it comes again, it joins again where it was dropped meanwhile. */
    private void onRetired(String boatId) {
        joined.remove(boatId);
        links.remove(boatId);
    }

    private void onRestarted(BoatStatus status) {
        tell(
                status.boatId(),
                Priority.CRITICAL,
                status.boatId() + " has started anew; it does not move until it is allowed to");
    }

    /** Of a vehicle that nobody of a base has taken, its gateway tells who has. */
    private void onCommanding(FleetEvent.CommanderChanged change) {
        String boatId = change.boat();
        if (!change.commands()) {
            observed.add(boatId);
            if (change.controller().isEmpty()) {
                tell(boatId, Priority.HIGH, "Another base commands " + boatId + " now; its commands wait");
            }
        } else if (observed.remove(boatId)) {
            tell(boatId, Priority.LOW, "This base commands " + boatId + " again");
        }
    }

    private void onHoldsPlace(String boatId, BoatCommand givenUp) {
        messages.tell(new OperatorMessage(
                host.nowMillis(),
                givenUp.mission(),
                OperatorMessage.Source.DOMAIN,
                Priority.MEDIUM,
                boatId + " holds its place, as its path was given up, until it gets a command or is stopped",
                List.of(boatId),
                ""));
    }

    private void onRefused(String boatId, String reason) {
        tell(boatId, Priority.HIGH, boatId + " refuses: " + reason);
    }

    /** News of the link does not take its place: the boat stays stopped when the link is back. */
    private void onReleaseDropped(String boatId, String reason) {
        messages.tell(new OperatorMessage(
                host.nowMillis(),
                Ids.NONE,
                OperatorMessage.Source.DOMAIN,
                Priority.HIGH,
                boatId + " may still be stopped, as its release was dropped: " + reason
                        + "; release it again if it is to move",
                List.of(boatId),
                "release/" + boatId));
    }

    /** No later one takes its place: each says something else, and none says when it is over. */
    private void onSaid(LinkAlarm said) {
        messages.tell(new OperatorMessage(
                host.nowMillis(),
                Ids.NONE,
                OperatorMessage.Source.DOMAIN,
                said.priority(),
                said.text(),
                said.boatId().isEmpty() ? List.of() : List.of(said.boatId()),
                ""));
    }

    /** Said once of each fault: a listener that fails may do so with every pose. */
    private void onListenerFault(String listener, Throwable fault) {
        if (faults.size() < MOST_FAULTS && faults.add(listener + ": " + fault)) {
            messages.tell(new OperatorMessage(
                    host.nowMillis(),
                    Ids.NONE,
                    OperatorMessage.Source.DOMAIN,
                    Priority.HIGH,
                    "A fault in this program: " + listener + " failed at news of a boat (" + fault
                            + "); the news went to all others",
                    List.of(),
                    ""));
        }
    }

    private void tell(String boat, Priority priority, String text) {
        messages.tell(new OperatorMessage(
                host.nowMillis(),
                Ids.NONE,
                OperatorMessage.Source.DOMAIN,
                priority,
                text,
                List.of(boat),
                "link/" + boat));
    }
}
