package org.sami.crw.session;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import org.sami.crw.fleet.FleetEvent;
import org.sami.session.api.RefusedException;

/** Settings that were asked of boats, until each boat has taken or refused its own. For the fleet's thread, but where said. */
final class SettingReplies {
    private final Replies replies;
    private final Map<String, Replies.Reply<Void>> open = new HashMap<>(); // by the command's id

    SettingReplies(Replies replies) {
        this.replies = replies;
    }

    /**
     * Asks for a setting on the fleet's thread; from any thread.
     *
     * @param fleet the fleet's thread
     * @param ask sends it, and gives the id of its command
     * @return completes when the boat has taken it; fails with the boat's reason where it refuses, or does not answer
     */
    CompletionStage<Void> ask(Executor fleet, Supplier<String> ask) {
        Replies.Reply<Void> reply = replies.open();
        fleet.execute(() -> {
            try {
                open.put(ask.get(), reply);
            } catch (RuntimeException fault) {
                reply.fail(fault);
            }
        });
        return reply.stage();
    }

    /** Something happened to a boat. */
    void happened(FleetEvent event) {
        if (event instanceof FleetEvent.SettingTaken taken) {
            Replies.Reply<Void> reply = open.remove(taken.commandId());
            if (reply != null) {
                reply.complete(null);
            }
        } else if (event instanceof FleetEvent.SettingRefused refused) {
            Replies.Reply<Void> reply = open.remove(refused.commandId());
            if (reply != null) {
                reply.fail(new RefusedException(refused.boat() + " does not take it: " + refused.reason()));
            }
        }
    }
}
