package org.sami.crw.proxy;

import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Nack;

/** Who commands the boat: what the operator asks of it, and what the listener has been told. */
final class HandOver {
    private final String boatId;
    private final ProxyLink link;
    private final PendingRequests requests;
    private final DeferredNotifications announcements;
    private boolean toldCommanding;

    HandOver(String boatId, ProxyLink link, ProxyConfig config, DeferredNotifications announcements) {
        this.boatId = boatId;
        this.link = link;
        this.announcements = announcements;
        requests = new PendingRequests(link, config);
    }

    /** Asks it of the boat, in place of what was asked before; nothing is asked without a link. */
    void request(CommandMessage request, long nowMs) {
        requests.clear();
        if (link.state() == LinkState.LINKED) {
            requests.send(request, nowMs);
        }
    }

    /** Whether an answer was to such a request. */
    boolean answered(String commandId) {
        return requests.answered(commandId).isPresent();
    }

    /** Whether a refusal was of such a request; then the listener is told. */
    boolean refused(Nack nack) {
        boolean ours = answered(nack.commandId());
        if (ours) {
            announcements.add(l -> l.onRefused(boatId, nack.detail()));
        }
        return ours;
    }

    /** The boat has said who commands. */
    void settled() {
        boolean commanding = link.isCommanding();
        if (commanding != toldCommanding) {
            toldCommanding = commanding;
            announcements.add(l -> l.onCommanding(boatId, commanding));
        }
    }

    /** What was asked over a link that is gone is not asked again over the next. */
    void linkLost() {
        requests.clear();
    }

    void tick(long nowMs) {
        for (CommandMessage unanswered : requests.tick(nowMs)) {
            announcements.add(l -> l.onRefused(boatId, "the boat did not answer " + unanswered.type()));
        }
    }
}
