package org.sami.session.client;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.junit.jupiter.api.Test;

/** Which boats a front claims before it drives them: requests only. */
class RemoteFleetTest {
    private final List<String> asked = new ArrayList<>();
    private Optional<CompletableFuture<JsonNode>> late = Optional.empty();
    private final RemoteFleet fleet = new RemoteFleet(
            new RemoteRequests(this::reply, Runnable::run),
            () -> {
                throw new AssertionError("no models are needed");
            },
            Optional::empty,
            Optional::empty);

    private CompletionStage<JsonNode> reply(ObjectNode message) {
        asked.add(message.path("t").asText());
        return late.<CompletionStage<JsonNode>>map(one -> one)
                .orElseGet(() -> CompletableFuture.completedFuture(JsonNodeFactory.instance.objectNode()));
    }

    private void drive() {
        fleet.teleoperate("bella", 0.5, 0).toCompletableFuture().join();
    }

    @Test
    void boatIsClaimedOnceAndAnewAfterTheServerHasForgottenIt() {
        drive();
        drive();
        assertThat(asked).containsExactly("claim", "drive", "drive");

        fleet.unclaimed();
        drive();

        assertThat(asked).endsWith("drive", "claim", "drive");
    }

    @Test
    void claimOfAnEarlierConnectionCountsForNothingWhenItsReplyComesLate() {
        CompletableFuture<JsonNode> reply = new CompletableFuture<>();
        late = Optional.of(reply);
        CompletionStage<Void> claim = fleet.claim("bella");

        fleet.unclaimed();
        late = Optional.empty();
        reply.complete(JsonNodeFactory.instance.objectNode());
        assertThat(claim.toCompletableFuture()).isCompleted();
        drive();

        assertThat(asked).containsExactly("claim", "claim", "drive");
    }
}
