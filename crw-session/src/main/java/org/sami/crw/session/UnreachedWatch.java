package org.sami.crw.session;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.boat.UnreachedBoat;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.LinkReport;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;

/** Tells the models of addresses at which no boat has answered, and the session's health of those that do not for a while. For the fleet's thread. */
final class UnreachedWatch {

    private final OperatorModels models;
    private final MessageSink messages;
    private final Optional<RememberedBoats> remembered;
    private final Map<String, String> boatAt = new HashMap<>(); // of an earlier process, by address; asked once each
    private List<UnreachedBoat> shown = List.of();
    private Set<String> reported = Set.of();

    UnreachedWatch(OperatorModels models, MessageSink messages, Optional<RememberedBoats> remembered) {
        this.models = models;
        this.messages = messages;
        this.remembered = remembered;
    }

    /** This is how the links stand now. */
    void look(List<LinkReport> links, long nowMillis) {
        List<UnreachedBoat> unreached = new ArrayList<>();
        Set<String> known = new HashSet<>();
        for (LinkReport link : links) {
            known.add(address(link));
            if (link.boatId().isEmpty() && link.failedTries() > 0) {
                unreached.add(of(link, nowMillis));
            }
        }
        if (!unreached.equals(shown)) {
            shown = unreached;
            models.unreached().show(unreached);
        }
        report(known, nowMillis);
    }

    private UnreachedBoat of(LinkReport link, long nowMillis) {
        String address = address(link);
        String boat = boatAt.computeIfAbsent(address, this::boatOf);
        long since = nowMillis - link.failingForMs();
        long before = shown.stream()
                .filter(one -> one.address().equals(address) && one.tries() <= link.failedTries())
                .mapToLong(UnreachedBoat::sinceMillis)
                .findFirst()
                .orElse(since); // two clocks agree to within a tick: what began does not begin again a little later
        return new UnreachedBoat(address, boat, words(link.lastEvent()), link.refused(), link.failedTries(), before);
    }

    private static String address(LinkReport link) {
        return BoatAddress.of(link.address()).toString();
    }

    private String boatOf(String address) {
        return remembered.map(RememberedBoats::all).orElse(List.of()).stream()
                .filter(boat -> boat.address().map(BoatAddress::toString).equals(Optional.of(address)))
                .map(RememberedBoats.Remembered::boat)
                .findFirst()
                .orElse("");
    }

    private void report(Set<String> known, long nowMillis) {
        Set<String> late = new HashSet<>();
        for (UnreachedBoat one : shown) {
            if (nowMillis - one.sinceMillis() >= SessionDefaults.UNREACHED_AFTER_MS) {
                late.add(one.address());
                if (!reported.contains(one.address())) {
                    tell(one.address(), Priority.HIGH, one.sentence(), nowMillis);
                }
                models.health()
                        .report(new HealthFault(
                                HealthKind.UNREACHED_BOAT,
                                one.address(),
                                Priority.HIGH,
                                one.sentence(),
                                one.advice(),
                                "",
                                one.boat(),
                                Ids.NONE));
            }
        }
        reported.stream().filter(address -> !late.contains(address)).forEach(address -> {
            models.health().over(HealthKind.UNREACHED_BOAT, address);
            if (known.contains(address)) {
                tell(address, Priority.LOW, address + " answers now", nowMillis);
            }
        });
        reported = late;
    }

    private void tell(String address, Priority priority, String text, long nowMillis) {
        messages.tell(new OperatorMessage(
                nowMillis, Ids.NONE, OperatorMessage.Source.DOMAIN, priority, text, List.of(), "unreached/" + address));
    }

    /** The machine's words begin as a sentence does. */
    private static String words(String event) {
        return event.length() > 1 && Character.isLowerCase(event.charAt(1))
                ? Character.toLowerCase(event.charAt(0)) + event.substring(1)
                : event;
    }
}
