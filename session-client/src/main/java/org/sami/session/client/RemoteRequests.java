package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.function.Function;
import org.sami.spn.json.ProtocolJson;
import org.sami.spn.protocol.Input;

/** Asks a session's server for something; each reply arrives on the front's executor, after what followed from it. From any thread. */
final class RemoteRequests {
    private final Function<ObjectNode, CompletionStage<JsonNode>> server;
    private final Executor front;

    /**
     * Sends nothing yet.
     *
     * @param server takes a request and gives its reply, on any thread
     * @param front where replies arrive
     */
    RemoteRequests(Function<ObjectNode, CompletionStage<JsonNode>> server, Executor front) {
        this.server = server;
        this.front = front;
    }

    /** Sends a request. */
    CompletionStage<JsonNode> ask(ObjectNode message) {
        return onFront(server.apply(message));
    }

    /** Sends a request whose reply says no more than that it was done. */
    CompletionStage<Void> tell(ObjectNode message) {
        return ask(message).thenAccept(done -> {});
    }

    /** Hands an input to the session. */
    CompletionStage<JsonNode> input(Input input) {
        ObjectNode message = ServerRequests.message("input");
        message.set("input", ProtocolJson.input(input));
        return ask(message);
    }

    /** Hands an input to the session whose reply says no more than that it was taken. */
    CompletionStage<Void> post(Input input) {
        return input(input).thenAccept(done -> {});
    }

    /** What a stage gives, on the front's executor; its fault as it was before stages wrapped it. */
    <T> CompletionStage<T> onFront(CompletionStage<T> result) {
        CompletableFuture<T> arrived = new CompletableFuture<>();
        result.whenComplete((value, fault) -> front.execute(() -> {
            if (fault == null) {
                arrived.complete(value);
            } else {
                arrived.completeExceptionally(
                        fault instanceof CompletionException && fault.getCause() != null ? fault.getCause() : fault);
            }
        }));
        return arrived;
    }
}
