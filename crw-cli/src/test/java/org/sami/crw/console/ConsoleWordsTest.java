package org.sami.crw.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringReader;
import java.io.StringWriter;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionSetup;
import org.sami.spn.json.DomainLibrary;

/** The console of a domain that commands no boats. */
class ConsoleWordsTest {
    private static final String SCRIPT = """
            copters
            comm
            wait copters 1 within 0
            why nobody
            drop nobody
            add kite 45.7,10.72 1000
            map
            help
            help stop
            interrupts
            press nothing
            wait something
            on-fault wait
            log
            stop all
            release all
            help copters
            """;

    private static String said(String domain, String script) throws IOException {
        DomainLibrary library = DomainLibrary.fromClassPath(domain).orThrow();
        StringWriter out = new StringWriter();
        try (Session session = Session.open(SessionSetup.of(library.vocabulary(), library.combined()));
                Console console = new Console(session);
                PlainLines lines = new PlainLines("script", new StringReader(script), new PrintWriter(out))) {
            session.begin();
            console.run(lines);
        }
        return out.toString();
    }

    @Test
    void consoleOfCoptersHasNoBoats() throws IOException {
        String said = said("/org/sami/domain/uav", SCRIPT);

        assertThat(said.toLowerCase(Locale.ROOT)).doesNotContain("boat");
        assertThat(said)
                .contains("there is no copter")
                .contains("stop COPTER|all")
                .contains("Lists the copters, how they are and what they do.");
    }

    @Test
    void consoleOfATeamSpeaksOfRobotsAndTakesBoatsToo() throws IOException {
        String said = said("/org/sami/domain/team", "robots\nboats\nhelp robots\n");

        assertThat(said.split("there is no robot; connect one with: connect HOST:PORT", -1))
                .hasSize(3);
        assertThat(said).contains("Lists the robots, how they are and what they do.");
    }

    @Test
    void helpOfCoptersPromisesNoFlightByHandAndNoMotorsThatStopInTheAir() throws IOException {
        String said = said("/org/sami/domain/uav", "help drive\nhelp back\nhelp stop\n");

        assertThat(said)
                .contains("Is refused: copters are not flown by hand from here, but by the radio control of each.")
                .contains("Is not for copters, which are not flown by hand from here.")
                .contains("in the air it stays where it is, with its motors on;")
                .doesNotContain("Flies a copter by hand", "Stops motors at once");
    }

    @Test
    void helpOfATeamSaysWhichNamesMakeCoptersAndWhatCoptersDoOtherwise() throws IOException {
        String said = said("/org/sami/domain/team", "help add\nhelp drive\nhelp stop\n");

        assertThat(said)
                .contains("copters where the name begins with copter, as in copter1, else surface boats.")
                .contains("copters refuse it.")
                .contains("a copter in the air stays where it is, with its motors on;");
    }
}
