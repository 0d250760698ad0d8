package org.sami.crw.handler;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.boat.link.BatteryLevel;
import org.sami.crw.decision.MessageSink;
import org.sami.crw.decision.OperatorMessage;
import org.sami.crw.proxy.BatteryState;
import org.sami.crw.proxy.BoatListener;
import org.sami.crw.proxy.BoatStatus;
import org.sami.crw.proxy.LinkState;
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
final class BoatNews implements BoatListener {
    private final EngineHost host;
    private final MessageSink messages;
    private final Set<String> joined = new HashSet<>();
    private final Map<String, BatteryLevel> levels = new HashMap<>();

    BoatNews(EngineHost host, MessageSink messages) {
        this.host = host;
        this.messages = messages;
    }

    @Override
    public void onStatus(BoatStatus status) {
        host.postIfAwaited(Occurrence.news(EventNames.POSE_UPDATED, List.of(status.boatId()), Map.of()));
    }

    @Override
    public void onLinkChange(BoatStatus status) {
        String boat = status.boatId();
        if (status.link() == LinkState.LOST) {
            tell(boat, Priority.MEDIUM, "The link to " + boat + " is lost; its commands wait");
        } else if (status.link() == LinkState.LINKED && !joined.add(boat)) {
            tell(boat, Priority.LOW, "The link to " + boat + " is back");
        } else if (status.link() == LinkState.LINKED
                && !host.ask(view -> view.proxies().contains(boat))) {
            host.post(List.of(
                    new Input.ProxyJoined(boat),
                    new Input.Received(Occurrence.news(EventNames.PROXY_CREATED, List.of(boat), Map.of()))));
        }
    }

    @Override
    public void onBattery(String boatId, BatteryState battery) {
        if (levels.put(boatId, battery.level()) != battery.level()) {
            host.post(new Input.Received(Occurrence.news(
                    nameOf(battery.level()), List.of(boatId), Map.of("percent", new RealValue(battery.percent())))));
        }
    }

    @Override
    public void onRestarted(BoatStatus status) {
        tell(
                status.boatId(),
                Priority.CRITICAL,
                status.boatId() + " has started anew; it does not move until it is allowed to");
    }

    private static String nameOf(BatteryLevel level) {
        return switch (level) {
            case NOMINAL -> EventNames.BATTERY_NOMINAL;
            case LOW -> EventNames.BATTERY_LOW;
            case CRITICAL -> EventNames.BATTERY_CRITICAL;
        };
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
