package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.boat.BoatCommunication;
import org.sami.crw.operator.boat.ProxyStatus;
import org.sami.crw.service.Geodesy;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.protocol.Answer;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;

/**
 * Communications Monitoring (thesis 6.3.4) on a boat that is out of the radio's range and comes back into it, with everything real
 * but the hulls.
 */
class CommunicationsMonitoringTest {
    private static final String PLAN = "communications-monitoring";
    private static final GeoPoint BERTH = PlanScene.at(0, 40);

    private PlanScene scene;

    @BeforeEach
    void twoBoatsAreWatched() {
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        scene = new PlanScene(library.projectOf(PLAN).orElseThrow(), PLAN, 2, hull -> {});
        scene.answer(new Answer.Proxies(List.of("boat-1", "boat-2")));
        scene.answer(new Answer.Fields(Map.of("@home", BERTH)));
        scene.untilBoat("boat-1", "listen").untilBoat("boat-2", "rest");
    }

    private ProxyStatus status(String boat) {
        return scene.world.operator.communication().snapshot().stream()
                .filter(each -> each.boat().equals(boat))
                .map(BoatCommunication::status)
                .findFirst()
                .orElseThrow();
    }

    private boolean isHome(String boat) {
        return Geodesy.distanceM(scene.world.hull(boat).position(), BERTH) < 8;
    }

    @Test
    void boatInReachIsHeardAgainAndAgain() {
        scene.run(60);

        assertThat(status("boat-1")).isEqualTo(ProxyStatus.NOMINAL);
        assertThat(scene.messages()).noneMatch(text -> text.startsWith("Nothing has been heard"));
    }

    @Test
    void silentBoatIsAWarningThenCriticalThenSentHomeUntilItArrives() {
        scene.world.cutLink("boat-1", true);

        scene.untilBoat("boat-1", "warning");
        assertThat(status("boat-1")).isEqualTo(ProxyStatus.WARNING);
        scene.untilBoat("boat-1", "critical");
        assertThat(status("boat-1")).isEqualTo(ProxyStatus.SEVERE);
        assertThat(status("boat-2")).isEqualTo(ProxyStatus.NOMINAL);
        scene.untilBoat("boat-1", "go-home");
        scene.run(60);
        assertThat(scene.stands(PlanScene.boat("boat-1"), "go-home")).isTrue();
        assertThat(scene.world.hull("boat-1").isAtRest()).isTrue();
        assertThat(scene.messages()).doesNotContain("A boat cannot come home: fetch it");

        scene.world.cutLink("boat-1", false);
        scene.until("boat-1 is home", () -> isHome("boat-1"));
        scene.untilBoat("boat-1", "rest");
        assertThat(status("boat-1")).isEqualTo(ProxyStatus.NOMINAL);
        assertThat(isHome("boat-2")).as("the boat that was in reach stays").isFalse();
    }

    @Test
    void boatThatIsHeardInTimeIsNotSentHome() {
        scene.world.cutLink("boat-1", true);
        scene.untilBoat("boat-1", "critical");
        scene.run(10);

        scene.world.cutLink("boat-1", false);
        scene.untilBoat("boat-1", "rest");
        scene.run(60);

        assertThat(status("boat-1")).isEqualTo(ProxyStatus.NOMINAL);
        assertThat(scene.world.hull("boat-1").isAtRest()).isTrue();
        assertThat(isHome("boat-1")).isFalse();
    }

    @Test
    void timersThatAreAdjustedHoldFromTheNextOneOn() {
        Value seconds = new DurationValue(3000);
        scene.press("adjust timers");
        scene.answer(new Answer.Fields(Map.of(
                "@warnAfter", seconds, "@criticalAfter", seconds, "@homeAfter", seconds, "@resendEvery", seconds)));
        scene.run(20);

        scene.world.cutLink("boat-1", true);
        scene.run(14);

        assertThat(scene.stands(PlanScene.boat("boat-1"), "go-home")).isTrue();
    }

    @Test
    void lossOfAllLinksMakesEveryBoatRedUntilTheRouterIsBack() {
        scene.world.cutLinks(true);
        scene.untilBoat("boat-1", "critical").untilBoat("boat-2", "critical");
        assertThat(List.of(status("boat-1"), status("boat-2"))).containsOnly(ProxyStatus.SEVERE);

        scene.world.cutLinks(false);
        scene.untilBoat("boat-1", "rest").untilBoat("boat-2", "rest");
        assertThat(List.of(status("boat-1"), status("boat-2"))).containsOnly(ProxyStatus.NOMINAL);
    }
}
