package org.sami.crw.proxy;

import java.util.function.UnaryOperator;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.Nack;
import org.sami.crw.fleet.DeferredEvents;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.link.PendingRequests;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.link.ProxyLink;
import org.sami.crw.proxy.status.LinkState;

/**
 * Latches the fleet stop on a boat and releases it. A stop is repeated until the boat acknowledges it, over lost links and new terms too. A release is
 * repeated only within the term in which the operator ordered it: sent later, it would undo a stop that another base has latched since. For the proxy's
 * thread.
 */
final class LatchRequests {
    private final String boatId;
    private final ProxyLink link;
    private final String clientId;
    private final PendingRequests requests;
    private final DeferredEvents announcements;
    private final BoatCondition condition;
    private final UnaryOperator<String> ids;
    private boolean stops; // the request that was made last
    private String term = ""; // in which the release was ordered
    private String stoppedBy = ""; // whose stop it was to end

    /**
     * Nothing is asked yet.
     *
     * @param ids makes the id of a command from its subject
     */
    LatchRequests(
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
        clientId = config.clientId();
        requests = new PendingRequests(link, config);
    }

    /** Stops the boat, as soon as it can be reached. */
    void stop() {
        stops = true;
        requests.clear();
        requests.send(new FleetStop(ids.apply("fleet-stop")), condition.nowMs);
    }

    /** Asks for an unanswered stop no longer, and releases the boat if this base commands it now. */
    void release() {
        stops = false;
        requests.clear();
        if (link.isCommanding()) {
            term = link.term();
            stoppedBy = condition.stoppedBy;
            requests.send(new FleetRelease(ids.apply("fleet-release")), condition.nowMs);
        } else if (condition.fleetStopped) {
            announceDropped(link.state() == LinkState.LINKED ? "another base commands it" : "there is no link to it");
        }
    }

    /** Whether the boat has still to answer. */
    boolean areWaiting() {
        return requests.areWaiting();
    }

    /** Whether an answer was to such a request. */
    boolean answered(String commandId) {
        return requests.answered(commandId).isPresent();
    }

    /** The boat has refused something. A refused stop is repeated. */
    void refused(Nack nack) {
        if (isReleasing() && answered(nack.commandId())) {
            announceDropped("the boat refused it: " + nack.detail());
        }
    }

    /** The link is gone; what happens to the boat meanwhile is not known here. */
    void linkLost() {
        drop("its link was lost before it answered");
    }

    /** The boat has said whether this base commands it, and in which term. */
    void welcomed() {
        if (!link.isCommanding()) {
            drop("another base commands it");
        } else if (!link.term().equals(term)) {
            drop("the boat was stopped by another base, or commanded anew, before it answered");
        }
    }

    /** The boat has said who latched its stop; empty text for nobody. */
    void reported(String client) {
        if (!client.isEmpty() && !client.equals(stoppedBy) && !client.equals(clientId)) {
            drop(client + " has stopped it");
        }
    }

    /** Sends again what is due, without end. */
    void tick() {
        boolean mayAsk = link.isCommanding() || (stops && link.state() == LinkState.LINKED && link.isNumbered());
        if (mayAsk) {
            requests.tick(condition.nowMs).forEach(request -> requests.send(request, condition.nowMs));
        }
    }

    private boolean isReleasing() {
        return !stops && requests.areWaiting();
    }

    private void drop(String why) {
        if (isReleasing()) {
            requests.clear();
            announceDropped(why);
        }
    }

    private void announceDropped(String why) {
        announcements.add(new FleetEvent.ReleaseDropped(boatId, why));
    }
}
