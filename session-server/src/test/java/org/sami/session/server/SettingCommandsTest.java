package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.operator.OperatorLogEntry;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.session.Session;
import org.sami.session.person.PersonRole;
import org.sami.session.server.testing.ServedSession;

/** Settings of a real boat, set by people over real sockets on loopback. */
class SettingCommandsTest {
    private static final String SET = "{\"t\":\"set\",\"id\":%d,\"boat\":\"bella\",\"setting\":%s}";

    @TempDir
    private Path folder;

    private ServedSession served;
    private Session session;
    private SessionServer server;
    private MeasuringBoat boat;

    @BeforeEach
    void serve() throws Exception {
        served = ServedSession.ofPlan("station-keep", folder)
                .with("anna", PersonRole.OPERATOR)
                .with("paul", PersonRole.PILOT);
        session = served.session();
        server = served.serve();
        served.begin();
        boat = new MeasuringBoat();
        boat.join(session);
    }

    @AfterEach
    void end() throws Exception {
        boat.close();
        served.close();
    }

    private TestFront login(String name) throws Exception {
        return TestFront.loggedIn(server, name, "key of " + name);
    }

    private BoatTuning inForce() throws Exception {
        Optional<BoatTuning> known =
                session.fleet().settings("bella").toCompletableFuture().get();
        return known.orElseThrow();
    }

    @Test
    void doneComesWhenTheBoatHasTakenIt() throws Exception {
        TestFront anna = login("anna");

        List<String> settings = List.of(
                "\"heading\",\"p\":1.5,\"i\":0,\"d\":0.25",
                "\"velocity\",\"multiplier\":0.5",
                "\"lost-link\",\"action\":\"drift\"");
        for (String setting : settings) {
            anna.send(SET.formatted(1, setting));
            assertThat(anna.reply(1).path("t").asText()).isEqualTo("done");
        }

        assertThat(inForce().heading()).isEqualTo(new Gains(1.5, 0, 0.25));
        assertThat(inForce().velocityMultiplier()).isEqualTo(0.5);
        assertThat(inForce().lostLinkAction()).isEqualTo(LostLinkAction.DRIFT);
    }

    @Test
    void whatDoesNotFitIsRefusedInWordsAndTheBoatKeepsItsSettings() throws Exception {
        TestFront anna = login("anna");
        BoatTuning before = inForce();

        anna.send(SET.formatted(1, "\"velocity\",\"multiplier\":99"));
        assertThat(anna.reply(1).path("text").asText()).contains("99");
        anna.send(SET.formatted(2, "\"speed\",\"p\":-1,\"i\":0,\"d\":0"));
        assertThat(anna.reply(2).path("text").asText()).contains("-1");
        anna.send(SET.formatted(3, "\"lost-link\",\"action\":\"swim\""));
        JsonNode third = anna.until(message -> message.path("bad").asBoolean());
        assertThat(third.path("text").asText()).isEqualTo("'action' is hold, return, continue or drift");
        assertThat(inForce()).isEqualTo(before);
    }

    @Test
    void wishOfTheSessionIsOneForAllBoatsAndSetsNone() throws Exception {
        TestFront anna = login("anna");
        LostLinkAction before = inForce().lostLinkAction();

        anna.send("{\"t\":\"set\",\"id\":1,\"setting\":\"lost-link-wish\",\"action\":\"return\"}");
        assertThat(anna.reply(1).path("t").asText()).isEqualTo("done");

        assertThat(session.fleet().lostLinkWish()).contains(LostLinkAction.RETURN);
        assertThat(inForce().lostLinkAction()).isEqualTo(before).isNotEqualTo(LostLinkAction.RETURN);
        session.models().shown().toCompletableFuture().get();
        assertThat(session.models().log().snapshot())
                .extracting(OperatorLogEntry::text)
                .contains("anna wished that boats return when their link is lost");

        anna.send("{\"t\":\"set\",\"id\":2,\"setting\":\"lost-link-wish\",\"action\":\"nothing\"}");
        assertThat(anna.reply(2).path("t").asText()).isEqualTo("done");
        assertThat(session.fleet().lostLinkWish()).isEmpty();
    }

    @Test
    void wishThatIsNoneIsRefusedInWordsAndTheSessionKeepsItsOwn() throws Exception {
        session.fleet().wish(Optional.of(LostLinkAction.HOLD));
        TestFront anna = login("anna");

        anna.send("{\"t\":\"set\",\"id\":1,\"setting\":\"lost-link-wish\",\"action\":\"swim\"}");

        JsonNode refused = anna.until(message -> message.path("bad").asBoolean());
        assertThat(refused.path("text").asText()).isEqualTo("'action' is hold, return, continue, drift or nothing");
        assertThat(session.fleet().lostLinkWish()).contains(LostLinkAction.HOLD);
    }

    @Test
    void whoDrivesBoatsDoesNotSetThemUp() throws Exception {
        TestFront paul = login("paul");

        paul.send(SET.formatted(1, "\"velocity\",\"multiplier\":0.5"));

        assertThat(paul.reply(1).path("text").asText())
                .isEqualTo("The role pilot of paul does not have the right 'setup'");
        paul.send("{\"t\":\"set\",\"id\":2,\"setting\":\"lost-link-wish\",\"action\":\"return\"}");
        assertThat(paul.reply(2).path("text").asText())
                .isEqualTo("The role pilot of paul does not have the right 'setup'");
        assertThat(session.fleet().lostLinkWish()).isEmpty();
    }
}
