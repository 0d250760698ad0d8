package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.session.Session;
import org.sami.session.map.TestTiles;
import org.sami.session.map.TileFile;
import org.sami.session.person.PeopleFile;
import org.sami.session.person.PersonRole;
import org.sami.session.server.testing.ServedSession;

/** The page in a real browser, of a session that one base holds while another is its standby: one session, served by whichever of two servers holds it. */
@Tag("long")
@Timeout(900)
class SessionPageBasesTest {
    private static final String STATE = "document.getElementById('state').textContent";

    @TempDir
    private Path folder;

    private ServedSession served;
    private Session session;
    private PeopleFile people;
    private SessionServer holder;
    private StandbyServer standby;
    private TestBrowser browser;

    @BeforeEach
    void serveAtOneBaseAndWaitAtTheOther() throws Exception {
        Optional<Path> program = TestBrowser.installed();
        assumeTrue(program.isPresent(), "there is no Chromium; get one by: apt-get install chromium");
        served = ServedSession.ofPlan("station-keep", folder).with("anna", PersonRole.OPERATOR);
        session = served.session();
        people = served.people();
        standby = StandbyServer.start(people, ServerAddress.onThisMachine(0), Optional.empty(), SessionBases.NONE);
        int second = standby.listensAt().getPort();
        holder = serve(0, second);
        standby.close();
        standby = StandbyServer.start(
                people, ServerAddress.onThisMachine(second), Optional.empty(), bases(port(holder), second));
        standby.say("the session is held by laptop-1");
        served.begin();
        browser = new TestBrowser(program.get(), folder.resolve("profile"));
    }

    @AfterEach
    void end() throws Exception {
        if (browser != null) {
            browser.close();
            standby.close();
            served.close();
        }
    }

    private SessionServer serve(int port, int other) throws IOException {
        return served.serve(ServerAddress.onThisMachine(port), bases(other));
    }

    private static SessionBases bases(int... ports) {
        return SessionBases.parse(
                Arrays.stream(ports).mapToObj(port -> "ws://127.0.0.1:" + port).toList());
    }

    private static int port(SessionServer server) {
        return server.listensAt().getPort();
    }

    private void join(String url) throws Exception {
        browser.open(url);
        browser.until("document.getElementById('login') !== null && !document.getElementById('login').hidden");
        browser.type("#login-name", "anna");
        browser.type("#login-key", "key of anna");
        browser.click("#login button");
        browser.until(STATE + ".includes('anna (operator)')");
    }

    /** Whether the page has been told of a base. */
    private static String knows(int port) {
        return "(localStorage.getItem('bases') ?? '').includes('127.0.0.1:" + port + "')";
    }

    @Test
    void pageGoesOnAtTheBaseThatTakesOverWithWhatIsHalfFilledIn() throws Exception {
        join(holder.url());
        browser.click("#tabs button:nth-child(3)");
        browser.until("document.querySelector('#plans option[value=station-keep]') !== null");
        browser.value("document.getElementById('plans').value = 'station-keep'");
        browser.click("#panel .start button.main");
        browser.click("#tabs button:nth-child(1)");
        browser.click("#panel button.row");
        ServedPage.drawPoint(browser);
        int first = port(holder);
        int second = standby.listensAt().getPort();

        holder.close();
        browser.until(STATE + ".includes('; trying 127.0.0.1:" + first + ", 127.0.0.1:" + second + "')");
        browser.until(STATE + ".includes('127.0.0.1:" + second + ", a standby: the session is held by laptop-1')");
        standby.close();
        holder = serve(second, first);

        browser.until(STATE + ".includes('anna (operator)')");
        browser.until("document.getElementById('notice').textContent"
                + ".includes('At another base of the session now: 127.0.0.1:" + second + "')");
        browser.until("document.querySelector('.decision .draw output').textContent === '1 point'");
        browser.value("document.querySelectorAll('.decision input[type=number]').forEach(one => one.value ||= 1)");
        browser.click(".decision .answers button.main");
        browser.until("document.querySelector('.decision') === null");
        assertThat(session.faults().failure()).isEmpty();
    }

    /** Small pictures of bella that are shown, not only announced. */
    private static final String SHOWN =
            "[...document.querySelectorAll('.strip img')].filter((one) => one.naturalWidth > 0).length";

    private void showPicturesOfBella() throws Exception {
        browser.click("#tabs button:nth-child(2)");
        browser.until("document.querySelector('#panel button.row') !== null");
        browser.click("#panel button.row");
        browser.until(SHOWN + " > 0");
    }

    @Test
    void pageOfAStandbyShowsPicturesOfTheHolder() throws Exception {
        try (MeasuringBoat boat = new MeasuringBoat()) {
            boat.join(session);
            TakenPanorama.give(session, folder);
            join(standby.url());

            showPicturesOfBella();
        }
    }

    @Test
    void pageGetsPicturesAndMapOfTheBaseThatTookOver() throws Exception {
        try (MeasuringBoat boat = new MeasuringBoat();
                TileFile map = TileFile.open(TestTiles.write(folder.resolve("lake.mbtiles"), "png", 0, 0, 0))) {
            boat.join(session);
            TakenPanorama.give(session, folder);
            int first = port(holder);
            int second = standby.listensAt().getPort();
            join(holder.url());
            browser.until("document.querySelector('.leaflet-tile') === null"); // the first base has no map
            browser.until(knows(second)); // told with the first rows, after the welcome

            holder.close();
            standby.close();
            try (SessionServer other = SessionServer.start(
                    session, people, ServerAddress.onThisMachine(second), Optional.of(map), bases(first))) {
                assertThat(port(other)).isEqualTo(second);
                browser.until(STATE + ".includes('anna (operator)')");
                showPicturesOfBella();
                browser.until("[...document.querySelectorAll('.leaflet-tile')].some((one) => one.naturalWidth > 0"
                        + " && one.src.startsWith('http://127.0.0.1:" + second + "/tiles/'))");
                assertThat(browser.value("location.port").asText()).isEqualTo("" + first);
            }
        }
    }

    @Test
    void pageOfAStandbyTakesPartInTheSessionOfTheHolder() throws Exception {
        join(standby.url());

        assertThat(browser.value("location.port").asText())
                .isEqualTo("" + standby.listensAt().getPort());
        assertThat(browser.value("localStorage.getItem('bases')").asText()).contains("127.0.0.1:" + port(holder));
    }
}
