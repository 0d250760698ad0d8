package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletionStage;
import org.sami.session.api.GuidedBoats;
import org.sami.session.api.WayByHand;
import org.sami.spn.value.GeoPoint;

/** Sends boats of a session in another process, each claimed for this person first. From any thread. */
final class RemoteByHand implements GuidedBoats {
    private final ServerRequests server;
    private final RemoteFleet fleet;

    RemoteByHand(ServerRequests server, RemoteFleet fleet) {
        this.server = server;
        this.fleet = fleet;
    }

    private CompletionStage<JsonNode> claimed(String boat, ObjectNode message) {
        return fleet.claim(boat).thenCompose(mine -> server.ask(message.put("boat", boat)));
    }

    @Override
    public CompletionStage<WayByHand> goTo(String boat, GeoPoint point) {
        ObjectNode message =
                ServerRequests.message("goTo").put("lat", point.latDeg()).put("lon", point.lonDeg());
        return claimed(boat, message).thenApply(RemoteByHand::way);
    }

    @Override
    public CompletionStage<WayByHand> goHome(String boat) {
        return claimed(boat, ServerRequests.message("goHome")).thenApply(RemoteByHand::way);
    }

    private static WayByHand way(JsonNode done) {
        List<GeoPoint> points = new ArrayList<>();
        done.path("points")
                .forEach(at ->
                        points.add(GeoPoint.of(at.path(0).asDouble(), at.path(1).asDouble())));
        return new WayByHand(points, LinkRowReader.texts(done.path("warnings")));
    }

    @Override
    public CompletionStage<Void> hold(String boat) {
        return claimed(boat, ServerRequests.message("holdBoat")).thenAccept(done -> {});
    }

    @Override
    public CompletionStage<Void> giveBack(String boat) {
        return fleet.claim(boat).thenCompose(mine -> fleet.handBack(boat));
    }
}
