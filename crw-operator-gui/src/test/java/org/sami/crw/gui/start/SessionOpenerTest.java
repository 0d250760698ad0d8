package org.sami.crw.gui.start;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.session.Session;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

@Tag("long")
@Timeout(900)
class SessionOpenerTest {
    @TempDir
    private Path folder;

    @Test
    void theBuiltInFleetFaresInTheConditionsThatAreNamedAlsoWhenItsSessionIsGoneOnWith() throws Exception {
        try (DataDirectory data = DataDirectory.open(folder)) {
            SessionOpener rough =
                    new SessionOpener(data, List.of(), Optional.empty(), Optional.of(NamedConditions.ROUGH));
            try (Session session = rough.openNew()) {
                assertThat(errorOf("anna", session))
                        .isEqualTo(NamedConditions.ROUGH.conditions().crossTrackError());
            }
            SessionOpener again = new SessionOpener(data, List.of(), Optional.empty());
            try (Session session = again.resume(data.unfinished().orElseThrow())) {
                assertThat(errorOf("anna", session))
                        .isEqualTo(NamedConditions.ROUGH.conditions().crossTrackError());
                assertThat(again.named()).contains(NamedConditions.ROUGH);
            }
        }
    }

    @Test
    void theBoatsOfTheBuiltInFleetAreWhereTheyWereWhenTheirSessionIsGoneOnWith() throws Exception {
        try (DataDirectory data = DataDirectory.open(folder)) {
            GeoPoint last;
            try (Session session = new SessionOpener(data, List.of(), Optional.empty()).openNew()) {
                errorOf("anna", session);
                GeoPoint quay = position("anna", session);
                GeoPoint there = GeoPoint.of(quay.latDeg(), quay.lonDeg() + 0.001);
                session.byHand().goTo("anna", there).toCompletableFuture().get(300, TimeUnit.SECONDS);
                Await.until("anna is off the quay", () -> Geodesy.distanceM(quay, position("anna", session)) > 25);
                last = position("anna", session);
            }
            SessionOpener again = new SessionOpener(data, List.of(), Optional.empty());
            try (Session session = again.resume(data.unfinished().orElseThrow())) {
                errorOf("anna", session);

                assertThat(Geodesy.distanceM(last, position("anna", session))).isLessThan(10);
            }
        }
    }

    private static GeoPoint position(String boat, Session session) {
        Await.until(boat + " says where it is", () -> pose(boat, session).isPresent());
        return pose(boat, session).orElseThrow();
    }

    private static Optional<GeoPoint> pose(String boat, Session session) {
        return session.fleet()
                .ask(boats ->
                        boats.find(boat).flatMap(proxy -> proxy.status().pose()).map(BoatPose::position))
                .toCompletableFuture()
                .orTimeout(300, TimeUnit.SECONDS)
                .join();
    }

    @Test
    void wayOfAPathThatAnOptionShowsLeadsAroundTheNoGoAreasOfTheProject() throws Exception {
        try (DataDirectory data = DataDirectory.open(folder);
                Session session = new SessionOpener(data, List.of(), Optional.empty()).openNew()) {
            errorOf("anna", session);
            position("anna", session);
            GeoPoint behind = GeoPoint.of(25.3615, 51.532);
            List<GeoPoint> way = wayOf("anna", new GeoPath(List.of(behind)), session);
            List<GeoPoint> free = wayOf("anna", new GeoPath(List.of(GeoPoint.of(25.36, 51.528))), session);

            assertThat(way).hasSizeGreaterThan(2).endsWith(behind);
            assertThat(free).hasSize(2);
        }
    }

    private static List<GeoPoint> wayOf(String boat, GeoPath path, Session session) {
        return session.way(Ids.NONE, boat, path)
                .toCompletableFuture()
                .orTimeout(300, TimeUnit.SECONDS)
                .join()
                .orElseThrow();
    }

    /** What a boat says of itself. */
    private static CrossTrackError errorOf(String boat, Session session) throws Exception {
        session.begin();
        Await.until(boat + " says it", () -> ask(boat, session).isPresent());
        return ask(boat, session).orElseThrow();
    }

    private static Optional<CrossTrackError> ask(String boat, Session session) {
        return session.fleet()
                .ask(boats -> boats.find(boat).flatMap(BoatProxy::error))
                .toCompletableFuture()
                .orTimeout(300, TimeUnit.SECONDS)
                .join();
    }
}
