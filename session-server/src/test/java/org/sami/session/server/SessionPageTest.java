package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.spn.value.GeoPoint;

/** The page of a served session in a real browser of a phone's size. */
@Tag("long")
@Timeout(900)
class SessionPageTest {
    private static final InetSocketAddress ANY_PORT = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);

    @TempDir
    private Path folder;

    private ServedPage page;
    private Session session;
    private TestBrowser browser;

    @BeforeEach
    void openThePage() throws Exception {
        page = new ServedPage(ServedPage.LIBRARY.projectOf("station-keep").orElseThrow(), folder);
        session = page.session;
        browser = page.browser;
    }

    @AfterEach
    void end() throws Exception {
        if (page != null) {
            page.close();
        }
    }

    @Test
    void personStartsAMissionAndAnswersItsQuestion() throws Exception {
        page.join();
        page.start("station-keep");
        browser.click("#panel button.row");
        browser.until("document.querySelector('.decision .fields') !== null");
        browser.value("document.querySelectorAll('.decision input[type=number]').forEach(one => one.value ||= 1)");
        ServedPage.drawPoint(browser);
        browser.click(".decision .answers button.main");

        browser.until("document.querySelector('.decision') === null");
        browser.until("document.getElementById('notice').textContent !== ''");
        assertThat(browser.value("document.querySelector('#tabs button:nth-child(3)').textContent")
                        .asText())
                .isEqualTo("Missions1");
    }

    @Test
    void halfFilledAnswerStaysWhileAnotherListIsLookedAt() throws Exception {
        page.join();
        page.start("station-keep");
        browser.click("#panel button.row");
        ServedPage.drawPoint(browser);

        browser.click("#tabs button:nth-child(2)");
        browser.until("document.querySelector('.decision') === null");
        browser.click("#tabs button:nth-child(1)");
        browser.click("#panel button.row");

        browser.until("document.querySelector('.decision .draw output').textContent === '1 point'");
    }

    @Test
    void pageFollowsARoleThatIsChangedMeanwhile() throws Exception {
        page.join();
        browser.click("#tabs button:nth-child(3)");
        browser.until("document.querySelector('#panel .start button.main') !== null");

        Path people = folder.resolve("people");
        Files.writeString(people, Files.readString(people).replace("operator", "observer"));

        browser.until("document.getElementById('state').textContent.includes('anna (observer)')");
        browser.until("document.querySelector('#panel .start') === null");
    }

    @Test
    void noteIsInEverybodysNews() throws Exception {
        page.join();
        browser.click("#tabs button:nth-child(4)");
        browser.type("#note", "weed near the pier");
        browser.click("#panel .note button");

        browser.until("document.getElementById('notice').textContent.includes('anna notes: weed near the pier')");
    }

    @Test
    void boatIsDrivenByHandAsLongAsTheStickIsHeld() throws Exception {
        try (BoatOnTcp boat = new BoatOnTcp(
                BoatSettings.of("bella", ANY_PORT, GeoPoint.of(45.4, 10.9), 1),
                new SteadyClock(ProcessClock::ms),
                TcpServerListener.NONE)) {
            session.fleet()
                    .connect(new BoatAddress(
                            boat.address().getAddress().getHostAddress(),
                            boat.address().getPort()));
            page.join();
            browser.click("#tabs button:nth-child(2)");
            browser.until("document.querySelector('#panel button.row') !== null"
                    + " && document.querySelector('#panel button.row').textContent.includes('%')");
            browser.click("#panel button.row");
            browser.click("#panel .by-hand button");
            browser.until("document.querySelector('.stick') !== null");
            double[] stick = browser.middle(".stick");

            browser.mouse("mousePressed", stick[0], stick[1] - 60);
            Await.until("the boat goes", () -> speedMps() > 0.3);
            browser.mouse("mouseReleased", stick[0], stick[1] - 60);

            Await.until("the boat has stopped", () -> speedMps() < 0.1);
            browser.click("#panel .by-hand button.main");
            browser.until("document.querySelector('.stick') === null");
        }
    }

    @Test
    void copterIsNotTakenByHandFromThePage() throws Exception {
        try (BoatOnTcp copter = new BoatOnTcp(
                BoatSettings.of("copter1", ANY_PORT, GeoPoint.of(45.4, 10.9), 1).of(RobotKind.COPTER),
                new SteadyClock(ProcessClock::ms),
                TcpServerListener.NONE)) {
            session.fleet()
                    .connect(new BoatAddress(
                            copter.address().getAddress().getHostAddress(),
                            copter.address().getPort()));
            page.join();
            browser.click("#tabs button:nth-child(2)");
            browser.until("document.querySelector('#panel button.row') !== null"
                    + " && document.querySelector('#panel button.row').textContent.includes('%')");
            browser.click("#panel button.row");
            browser.until("document.querySelector('#panel button.row.selected') !== null");

            assertThat(browser.value("document.querySelector('#panel .by-hand') === null")
                            .asBoolean())
                    .isTrue();
            assertThat(browser.value("document.querySelector('#panel button.row').textContent")
                            .asText())
                    .contains(" 0 m up · ");
        }
    }

    @Test
    void boatThatTheSamePersonDrivesOnAnotherScreenHasNoStickHere() throws Exception {
        try (MeasuringBoat boat = new MeasuringBoat()) {
            boat.join(session);
            page.join();
            browser.click("#tabs button:nth-child(2)");
            browser.until("document.querySelector('#panel button.row') !== null");
            browser.click("#panel button.row");
            browser.until("document.querySelector('.by-hand button') !== null");

            TestFront other = TestFront.loggedIn(page.server, "anna", "key of anna");
            other.send("{\"t\":\"claim\",\"id\":1,\"boat\":\"bella\"}");

            assertThat(other.reply(1).path("t").asText()).isEqualTo("done");
            browser.until("document.querySelector('.by-hand').textContent === 'anna drives it on another screen.'");
        }
    }

    @Test
    void missionThatIsShownAddsNoListenersToTheWindow() throws Exception {
        page.join();
        page.start("station-keep");
        browser.click("#tabs button:nth-child(3)");
        browser.until("document.querySelector('#panel .mission button.danger') !== null");
        browser.value("window.added = 0; window.words = document.querySelector('#panel .mission p').textContent;"
                + " window.addEventListener = () => window.added++");

        browser.until("document.querySelector('#panel .mission p').textContent !== window.words"); // made again

        assertThat(browser.value("window.added").asInt()).isZero();
    }

    @Test
    void readingsOfABoatAreListedAndDrawnOnTheMap() throws Exception {
        try (MeasuringBoat boat = new MeasuringBoat()) {
            boat.join(session);
            page.join();
            browser.until("document.querySelectorAll('#layer option').length === 3");
            browser.click("#tabs button:nth-child(2)");
            browser.until("document.querySelector('#panel button.row') !== null");
            browser.click("#panel button.row");
            browser.until("document.querySelector('.readings')?.textContent.includes('°C')");
            assertThat(browser.value("document.querySelector('.readings').textContent")
                            .asText())
                    .contains("Temperature", "Oxygen", "mg/L", " s ago");

            browser.value("document.getElementById('layer').selectedIndex = 2");
            browser.value("document.getElementById('layer').dispatchEvent(new Event('change'))");

            browser.until("document.querySelector('img.field-image') !== null");
            assertThat(browser.value("document.getElementById('legend').textContent")
                            .asText())
                    .endsWith(" °C");
        }
    }

    @Test
    void picturesOfABoatAreShownAndStoredNowhere() throws Exception {
        try (MeasuringBoat boat = new MeasuringBoat()) {
            boat.join(session);
            TakenPanorama.give(session, folder);
            page.join();
            browser.value("navigator.serviceWorker.ready.then(() => location.reload())");
            browser.until("navigator.serviceWorker.controller !== null"
                    + " && document.getElementById('state')?.textContent.includes('anna (operator)')");
            browser.click("#tabs button:nth-child(2)");
            browser.until("document.querySelector('#panel button.row') !== null");
            browser.click("#panel button.row");
            browser.until("document.querySelector('.thumb img')?.naturalWidth === 320");
            browser.click(".thumb");
            browser.until("document.querySelector('#viewer img')?.naturalWidth === 1600");

            assertThat(browser.value("document.querySelector('#viewer').textContent")
                            .asText())
                    .contains("bella · 1 of 2");
            browser.value(
                    "caches.match('picture', {ignoreSearch: true}).then((found) => (window.found = String(found)))");
            browser.until("window.found !== undefined");
            assertThat(browser.value("window.found").asText()).isEqualTo("undefined");

            browser.click("#viewer button[aria-label=Close]");
            browser.until("document.getElementById('viewer').hidden");
        }
    }

    @Test
    void pointThatIsDrawnIsDraggedToAnotherPlaceBeforeItIsConfirmed() throws Exception {
        page.join();
        page.start("station-keep");
        browser.click("#panel button.row");
        browser.click(".decision .draw button");
        double[] middle = browser.middle("#map");
        browser.press(middle[0], middle[1]);
        browser.until("document.querySelector('.handle') !== null");
        assertThat(browser.value("document.querySelector('.handle').offsetWidth")
                        .asInt())
                .isGreaterThanOrEqualTo(48);
        double[] handle = browser.middle(".handle");

        browser.mouse("mousePressed", handle[0], handle[1]);
        browser.mouse("mouseMoved", handle[0] + 40, handle[1] - 30);
        browser.mouse("mouseMoved", handle[0] + 80, handle[1] - 60);
        browser.mouse("mouseReleased", handle[0] + 80, handle[1] - 60);

        double[] moved = browser.middle(".handle");
        assertThat(moved[0]).isBetween(handle[0] + 70, handle[0] + 90);
        assertThat(moved[1]).isBetween(handle[1] - 70, handle[1] - 50);
        browser.click(".bar button:nth-last-child(2)"); // Undo
        browser.until(
                "Math.abs(document.querySelector('.handle').getBoundingClientRect().x + 24 - " + handle[0] + ") < 2");
    }

    private double speedMps() {
        return session.models().fleet().snapshot().stream()
                .mapToDouble(boat -> boat.speedMps().orElse(0))
                .sum();
    }

    @Test
    void wrongKeyIsSaidAtTheLogin() throws Exception {
        page.join("another key");

        browser.until("document.getElementById('login-fault').textContent !== ''");
        assertThat(browser.value("document.getElementById('login').hidden").asBoolean())
                .isFalse();
    }

    @Test
    void stopThatIsHeldStopsTheFleet() throws Exception {
        page.join();
        double[] stop = browser.middle("#stop");
        browser.press(stop[0], stop[1]); // a touch by accident
        assertThat(browser.value("document.getElementById('stop').classList.contains('held')")
                        .asBoolean())
                .isFalse();
        browser.mouse("mousePressed", stop[0], stop[1]);

        browser.until("!document.getElementById('stopped').hidden");
        assertThat(browser.value("document.getElementById('stopped').textContent")
                        .asText())
                .isNotEmpty();
    }

    @Test
    void fleetStopStaysInSightWithTextOfOneAndAHalfTimesTheSize() throws Exception {
        page.join();
        browser.value("document.documentElement.style.fontSize = '150%'");
        browser.value("document.body.style.width = '360px'");
        browser.click("#tabs button:nth-child(2)");

        assertThat(browser.value("document.documentElement.scrollWidth <= innerWidth")
                        .asBoolean())
                .isTrue();
        assertThat(browser.value("[...document.querySelectorAll('#stop, #tabs button')]"
                                + ".every(one => one.getBoundingClientRect().right <= 361 && one.offsetHeight >= 48)")
                        .asBoolean())
                .isTrue();
    }

    @Test
    void pageSaysWhenItHasLostTheSession() throws Exception {
        page.join();
        browser.until("document.getElementById('state').textContent.includes('0 of 0')");

        page.server.close();

        browser.until("document.getElementById('state').textContent.startsWith('Last seen ')");
    }

    @Test
    void everyFileThatThePageNeedsIsServedAndNoneComesFromElsewhere() throws Exception {
        page.join();

        browser.until("performance.getEntriesByType('resource').length > 6");
        assertThat(browser.value("performance.getEntriesByType('resource').map(one => one.name)"
                                + ".filter(one => !one.startsWith(location.origin + '/')).join()")
                        .asText())
                .isEmpty();
        assertThat(browser.value("performance.getEntriesByType('resource').filter(one => one.responseStatus >= 400)"
                                + ".map(one => one.name).join()")
                        .asText())
                .isEmpty();
    }
}
