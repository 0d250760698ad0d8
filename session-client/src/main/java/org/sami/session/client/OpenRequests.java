package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.sami.session.api.RefusedException;

/** The requests that the server has not answered yet. For one thread. */
final class OpenRequests {
    private final Map<Long, CompletableFuture<JsonNode>> open = new HashMap<>();
    private long last;

    /** A request that waits for this reply; gives its id. */
    long add(CompletableFuture<JsonNode> reply) {
        open.put(++last, reply);
        return last;
    }

    /** Takes a message that is {@code done} or {@code refused} of an open request; false for every other. */
    boolean settle(JsonNode message) {
        String type = message.path("t").asText();
        long id = message.path("id").asLong();
        if (!(type.equals("done") || type.equals("refused")) || !open.containsKey(id)) {
            return false;
        }
        CompletableFuture<JsonNode> asked = open.remove(id);
        if (type.equals("done")) {
            asked.complete(message);
        } else {
            asked.completeExceptionally(
                    new RefusedException(message.path("text").asText()));
        }
        return true;
    }

    /** Fails all requests: no reply will come. */
    void drop(String why) {
        List<CompletableFuture<JsonNode>> waiting = List.copyOf(open.values());
        open.clear();
        waiting.forEach(one -> one.completeExceptionally(new RefusedException(why)));
    }
}
