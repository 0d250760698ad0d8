package org.sami.crw.proxy;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.SetGains;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.SetVelocityMultiplier;
import org.sami.boat.link.SettingsReport;
import org.sami.crw.fleet.DeferredEvents;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.link.PendingRequests;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.link.ProxyLink;
import org.sami.crw.proxy.status.BoatTuning;

/**
 * The settings of one boat: requests them over its proxy's link, and knows those that the boat reports as in force. Only the newest request of each
 * kind is sent and repeated until the boat answers: an older unanswered one must not overtake it. The proxy's listener hears whether the boat took a
 * setting, and what is in force afterwards. For the proxy's thread.
 */
public final class ProxySettings {
    private final String boatId;
    private final ProxyLink link;
    private final ProxyConfig config;
    private final DeferredEvents announcements;
    private final BoatCondition condition;
    private final UnaryOperator<String> ids;
    private final Runnable afterwards;
    private final Map<String, PendingRequests> byKind = new LinkedHashMap<>();
    private Optional<BoatTuning> inForce = Optional.empty();

    /**
     * Settings of a boat that has said nothing yet.
     *
     * @param ids makes the id of a command of what it is about
     * @param afterwards called after each setting was asked for
     */
    ProxySettings(
            String boatId,
            ProxyLink link,
            ProxyConfig config,
            DeferredEvents announcements,
            BoatCondition condition,
            UnaryOperator<String> ids,
            Runnable afterwards) {
        this.boatId = boatId;
        this.link = link;
        this.config = config;
        this.announcements = announcements;
        this.condition = condition;
        this.ids = ids;
        this.afterwards = afterwards;
    }

    /** The settings that the boat said last are in force; empty before it said so. */
    public Optional<BoatTuning> inForce() {
        return inForce;
    }

    /**
     * Sets the gains of one of the boat's control loops.
     *
     * @return the id of the command, under which the listener gets the outcome
     */
    public String setGains(GainAxis axis, Gains gains) {
        return ask("gains " + axis, new SetGains(ids.apply("gains"), axis, gains));
    }

    /**
     * Scales the speed of every leg.
     *
     * @param multiplier 0 to {@link SetVelocityMultiplier#MAX_MULTIPLIER}; the boat's own limit still holds
     * @return the id of the command, under which the listener gets the outcome
     */
    public String setVelocityMultiplier(double multiplier) {
        return ask("velocity", new SetVelocityMultiplier(ids.apply("velocity"), multiplier));
    }

    /**
     * Sets what the boat does when the link is lost.
     *
     * @return the id of the command, under which the listener gets the outcome
     */
    public String setLostLinkAction(LostLinkAction action) {
        return ask("lost-link", new SetLostLinkAction(ids.apply("lost-link"), action));
    }

    private String ask(String kind, CommandMessage setting) {
        PendingRequests requests = byKind.computeIfAbsent(kind, unused -> new PendingRequests(link, config));
        requests.clear().forEach(older -> refused(older, "a newer setting took its place"));
        requests.send(setting, condition.nowMs);
        afterwards.run();
        return setting.commandId();
    }

    /** Asks for nothing any longer, for a reason in words. */
    void giveUp(String reason) {
        byKind.values().forEach(requests -> requests.clear().forEach(setting -> refused(setting, reason)));
    }

    private void refused(CommandMessage setting, String reason) {
        announcements.add(new FleetEvent.SettingRefused(boatId, setting.commandId(), reason));
    }

    void reported(SettingsReport report) {
        BoatTuning tuning = BoatTuning.of(report);
        inForce = Optional.of(tuning);
        announcements.add(new FleetEvent.SettingsReported(boatId, tuning));
    }

    /** Whether an answer was to a setting, which the boat has taken with it. */
    boolean answered(String commandId) {
        boolean setting = isSetting(commandId);
        if (setting) {
            announcements.add(new FleetEvent.SettingTaken(boatId, commandId));
        }
        return setting;
    }

    private boolean isSetting(String commandId) {
        return byKind.values().stream()
                .anyMatch(requests -> requests.answered(commandId).isPresent());
    }

    /** The boat has refused something. A setting that it may take later is asked for again; a refusal of another is reported to the listener. */
    void refused(Nack nack) {
        boolean willPass = switch (nack.reason()) {
            case NOT_GREETED, NOT_COMMANDER, STALE -> true;
            default -> false;
        };
        if (!willPass && isSetting(nack.commandId())) {
            announcements.add(new FleetEvent.SettingRefused(boatId, nack.commandId(), nack.detail()));
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
