package org.sami.crw.proxy;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.SettingsReport;

/**
 * Sets what can be set on a boat, and knows what it said is in force. Of each kind of setting the newest is asked for, and asked
 * again until the boat answers: an older one that is still unanswered must not overtake it.
 */
final class SettingsSender {
    private final String boatId;
    private final ProxyLink link;
    private final ProxyConfig config;
    private final DeferredNotifications announcements;
    private final Map<String, PendingRequests> byKind = new LinkedHashMap<>();
    private Optional<BoatTuning> inForce = Optional.empty();

    SettingsSender(String boatId, ProxyLink link, ProxyConfig config, DeferredNotifications announcements) {
        this.boatId = boatId;
        this.link = link;
        this.config = config;
        this.announcements = announcements;
    }

    /** What the boat said last; empty before it said anything. */
    Optional<BoatTuning> inForce() {
        return inForce;
    }

    /** Asks for a setting. Returns the id of the command, by which the listener hears what became of it. */
    String ask(String kind, CommandMessage setting, long nowMs) {
        PendingRequests requests = byKind.computeIfAbsent(kind, unused -> new PendingRequests(link, config));
        requests.clear().forEach(older -> refused(older, "a newer setting took its place"));
        requests.send(setting, nowMs);
        return setting.commandId();
    }

    /** Asks for nothing any longer, for a reason in words. */
    void giveUp(String reason) {
        byKind.values().forEach(requests -> requests.clear().forEach(setting -> refused(setting, reason)));
    }

    private void refused(CommandMessage setting, String reason) {
        announcements.add(l -> l.onTuningRefused(boatId, setting.commandId(), reason));
    }

    void reported(SettingsReport report) {
        BoatTuning tuning = BoatTuning.of(report);
        inForce = Optional.of(tuning);
        announcements.add(l -> l.onTuning(boatId, tuning));
    }

    /** Whether an answer was to a setting, which the boat has taken with it. */
    boolean answered(String commandId) {
        boolean setting = isSetting(commandId);
        if (setting) {
            announcements.add(l -> l.onTuningTaken(boatId, commandId));
        }
        return setting;
    }

    private boolean isSetting(String commandId) {
        return byKind.values().stream()
                .anyMatch(requests -> requests.answered(commandId).isPresent());
    }

    /** The boat has refused something. A setting that it may take later is asked for again; of another the listener is told. */
    void refused(Nack nack) {
        boolean willPass = switch (nack.reason()) {
            case NOT_GREETED, NOT_COMMANDER, STALE -> true;
            default -> false;
        };
        if (!willPass && isSetting(nack.commandId())) {
            announcements.add(l -> l.onTuningRefused(boatId, nack.commandId(), nack.detail()));
        }
    }

    void tick(long nowMs) {
        for (PendingRequests requests : byKind.values()) {
            for (CommandMessage unanswered : requests.tick(nowMs)) {
                refused(unanswered, "the boat did not answer " + unanswered.type());
            }
        }
    }
}
