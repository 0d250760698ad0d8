package org.sami.crw.proxy;

import java.util.function.UnaryOperator;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.GrantCommand;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.crw.fleet.DeferredEvents;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.link.PendingRequests;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.link.ProxyLink;
import org.sami.crw.proxy.status.LinkState;

/**
 * The hand-over of a boat's command between bases: what the operator asks of the boat, and what the proxy's listener knows of it.
 * Only one of several bases commands a boat. For the proxy's thread.
 */
public final class HandOver {
    private final String boatId;
    private final ProxyLink link;
    private final PendingRequests requests;
    private final DeferredEvents announcements;
    private final BoatCondition condition;
    private final UnaryOperator<String> ids;
    private boolean reportedCommanding;

    /**
     * A hand-over that no base has asked for yet.
     *
     * @param ids makes the id of a command from its subject
     */
    HandOver(
            String boatId,
            ProxyLink link,
            ProxyConfig config,
            DeferredEvents announcements,
            BoatCondition condition,
            UnaryOperator<String> ids) {
        this.boatId = boatId;
        this.link = link;
        this.announcements = announcements;
        this.condition = condition;
        this.ids = ids;
        requests = new PendingRequests(link, config);
    }

    /**
     * Observes the boat from now on, until this base asks for the command, takes it or is granted it. A boat that this base has commanded, and that
     * no other base takes over, starts its lost-link action.
     */
    public void observe() {
        link.observe();
        if (link.isCommanding()) {
            link.hello(condition.nowMs);
        }
    }

    /** Tells the boat that this base wishes to command it; who commands it then decides. */
    public void askForCommand() {
        request(link.askForCommand(ids.apply("ask-command")));
    }

    /** Commands the boat from now on, whoever did before: for an operator who knows why. */
    public void takeCommand() {
        request(link.takeCommand(ids.apply("take-command")));
    }

    /** Hands the command over to another client and observes; commands that are queued here wait. */
    public void grantCommand(String clientId) {
        request(new GrantCommand(ids.apply("grant-command"), clientId));
    }

    /** Asks it of the boat, in place of what was asked before; nothing is asked without a link. */
    private void request(CommandMessage request) {
        requests.clear();
        if (link.state() == LinkState.LINKED) {
            requests.send(request, condition.nowMs);
        }
    }

    /** Whether an answer was to such a request. */
    boolean answered(String commandId) {
        return requests.answered(commandId).isPresent();
    }

    /** Whether a refusal was of such a request; then the listener is notified. */
    boolean refused(Nack nack) {
        boolean ofHello =
                nack.reason() == NackReason.SUPERSEDED && nack.commandId().isEmpty();
        boolean replaced = ofHello && link.superseded(condition.nowMs);
        boolean ours = ofHello || answered(nack.commandId());
        if (replaced || (ours && !ofHello)) {
            announcements.add(new FleetEvent.Refused(boatId, nack.detail()));
        }
        return ours;
    }

    /** The boat has said who commands. */
    void settled() {
        boolean commanding = link.isCommanding();
        if (commanding != reportedCommanding) {
            reportedCommanding = commanding;
            announcements.add(new FleetEvent.CommanderChanged(boatId, commanding, link.controller()));
        }
    }

    /** What was asked over a link that is gone is not asked again over the next. */
    void linkLost() {
        requests.clear();
    }

    void tick(long nowMs) {
        for (CommandMessage unanswered : requests.tick(nowMs)) {
            announcements.add(new FleetEvent.Refused(boatId, "the boat did not answer " + unanswered.type()));
        }
    }
}
