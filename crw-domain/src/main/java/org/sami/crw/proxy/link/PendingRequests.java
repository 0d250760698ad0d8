package org.sami.crw.proxy.link;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.boat.link.CommandMessage;

/** The requests that the boat has not answered yet; each is sent again under its id until it is, or given up. */
public final class PendingRequests {
    private final ProxyLink link;
    private final ProxyConfig config;
    private final Map<String, Pending> unanswered = new LinkedHashMap<>();

    /** Nothing is asked yet. */
    public PendingRequests(ProxyLink link, ProxyConfig config) {
        this.link = link;
        this.config = config;
    }

    /** Asks it of the boat, until the boat answers. */
    public void send(CommandMessage request, long nowMs) {
        unanswered.put(request.commandId(), new Pending(request, nowMs + config.resendMs()));
        link.send(request, nowMs);
    }

    /** The request that an answer is for, which then is no longer waited for; empty for one that is answered already. */
    public Optional<CommandMessage> answered(String commandId) {
        return Optional.ofNullable(unanswered.remove(commandId)).map(pending -> pending.request);
    }

    /** Asks for nothing any longer. Returns what is still unanswered. */
    public List<CommandMessage> clear() {
        List<CommandMessage> dropped =
                unanswered.values().stream().map(pending -> pending.request).toList();
        unanswered.clear();
        return dropped;
    }

    /** Whether something is unanswered. */
    public boolean areWaiting() {
        return !unanswered.isEmpty();
    }

    /** How often the oldest request has been sent; 0 if none waits. */
    public int sends() {
        return unanswered.isEmpty() ? 0 : unanswered.values().iterator().next().sends;
    }

    /** Sends again what is due. Returns the requests that are given up. */
    public List<CommandMessage> tick(long nowMs) {
        List<CommandMessage> givenUp = new ArrayList<>();
        for (Pending pending : unanswered.values()) {
            if (nowMs < pending.dueMs) {
                continue;
            }
            if (pending.sends >= config.maxSends()) {
                givenUp.add(pending.request);
            } else {
                pending.sends++;
                pending.dueMs = nowMs + config.resendMs();
                link.send(pending.request, nowMs);
            }
        }
        givenUp.forEach(request -> unanswered.remove(request.commandId()));
        return givenUp;
    }

    private static final class Pending {
        private final CommandMessage request;
        private long dueMs;
        private int sends = 1;

        Pending(CommandMessage request, long dueMs) {
            this.request = request;
            this.dueMs = dueMs;
        }
    }
}
