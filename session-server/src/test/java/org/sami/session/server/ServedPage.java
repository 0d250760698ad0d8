package org.sami.session.server;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionSetup;
import org.sami.session.person.PeopleFile;
import org.sami.session.person.Person;
import org.sami.session.person.PersonKey;
import org.sami.session.person.PersonRole;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;

/** A session that is served to the operator anna, and its page in a real browser of a phone's size. */
final class ServedPage implements AutoCloseable {
    static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    final Session session;
    final SessionServer server;
    final TestBrowser browser;

    /** Serves a project, and opens the page at its login. Skips the test where there is no browser. */
    ServedPage(Project project, Path folder) throws Exception {
        Optional<Path> program = TestBrowser.installed();
        assumeTrue(program.isPresent(), "there is no Chromium; get one by: apt-get install chromium");
        session = Session.open(SessionSetup.of(LIBRARY.vocabulary(), project));
        PeopleFile people = new PeopleFile(folder.resolve("people"));
        people.add(new Person("anna", PersonRole.OPERATOR, List.of(), PersonKey.hash("key of anna")));
        people.add(new Person("ben", PersonRole.OPERATOR, List.of(), PersonKey.hash("key of ben")));
        server = SessionServer.start(session, people, ServerAddress.onThisMachine(0));
        session.begin();
        browser = new TestBrowser(program.get(), folder.resolve("profile"));
        browser.open(server.url());
    }

    /** A project, as a file has it, with single quotes. */
    static Project project(String json) {
        return new ProjectReader(LIBRARY.vocabulary())
                .readAndCheck(json.replace('\'', '"'))
                .orThrow();
    }

    /** Gives anna's name and a key. */
    void join(String key) throws Exception {
        browser.until("document.getElementById('login') !== null && !document.getElementById('login').hidden");
        browser.type("#login-name", "anna");
        browser.type("#login-key", key);
        browser.click("#login button");
    }

    /** Logs anna in. */
    void join() throws Exception {
        join("key of anna");
        browser.until("document.getElementById('state').textContent.includes('anna (operator)')");
    }

    /** Starts a mission of a plan on the page, and shows the decisions. */
    void start(String plan) throws Exception {
        browser.click("#tabs button:nth-child(3)");
        browser.until("document.querySelector('#plans option[value=" + plan + "]') !== null");
        browser.value("document.getElementById('plans').value = '" + plan + "'");
        browser.click("#panel .start button.main");
        browser.click("#tabs button:nth-child(1)");
    }

    /** Draws the point that the shown decision asks for, in the middle of the map. */
    static void drawPoint(TestBrowser browser) throws Exception {
        browser.click(".decision .draw button");
        double[] middle = browser.middle("#map");
        browser.press(middle[0], middle[1]);
        browser.until("document.querySelector('.bar').textContent.startsWith('1 point')");
        browser.click(".bar button.main");
    }

    @Override
    public void close() throws Exception {
        browser.close();
        server.close();
        session.close();
    }
}
