package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.CommandAsked;
import org.sami.boat.link.LinkCodec;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.decision.DefaultAnswers;
import org.sami.crw.decision.OfferedOption;
import org.sami.crw.decision.SimulatedOperator;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.Geodesy;
import org.sami.spn.engine.EngineView;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;

/** What the operator is asked about single boats, on a real engine. */
class BoatQuestionsTest {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private final HostedEngine engine =
            new HostedEngine(LIBRARY.projects().values().iterator().next());
    private TestWorld world = new TestWorld(engine);

    @BeforeEach
    void aBoatUnderWay() {
        world.addBoat("a", 0, 0);
        world.run(1);
        boat().commands().submit(path());
        world.run(3);
    }

    private BoatProxy boat() {
        return world.boats.find("a").orElseThrow();
    }

    private static FollowPath path() {
        return FollowPath.goTo("c", 1, 1, Geodesy.offset(TestWorld.HOME, 0, 300), Priority.MEDIUM);
    }

    private List<Decision> asked() {
        return world.operator.decisions().pending().stream()
                .map(PendingDecision::decision)
                .toList();
    }

    private void answer(boolean yes) {
        world.host.post(new Input.AnswerDecision(asked().get(0).id(), new Answer.YesNo(yes), Answerer.OPERATOR));
        world.run(2);
    }

    @Test
    void theOperatorIsAskedWhetherABoatThatStartedAnewMayMoveAndItMovesAfterAYes() {
        assertThat(world.hull("a").isAtRest()).isFalse();
        world.startServer("a", "a-boot2");
        world.run(5);

        assertThat(world.hull("a").isAtRest()).isTrue();
        assertThat(asked()).singleElement().satisfies(decision -> {
            assertThat(decision.prompt()).isEqualTo("a has started anew and does not move. May it move again?");
            assertThat(decision.priority()).isEqualTo(Priority.CRITICAL);
        });
        answer(true);

        assertThat(world.hull("a").isAtRest()).isFalse();
        assertThat(asked()).isEmpty();
        world.startServer("a", "a-boot3");
        world.run(5);
        assertThat(asked()).hasSize(1);
    }

    @Test
    void aBoatOfWhichTheOperatorSaysNoStays() {
        world.startServer("a", "a-boot2");
        world.run(5);
        answer(false);
        world.cutLinks(true);
        world.run(5);
        world.cutLinks(false);
        world.run(5);

        assertThat(world.hull("a").isAtRest()).isTrue();
        assertThat(boat().explain().text()).contains("nobody has allowed it to move again");
        assertThat(asked()).isEmpty();
    }

    @Test
    void aBoatThatStartedAnewWhileTheBaseWasDownIsAskedAboutAsWell() {
        world = new TestWorld(engine);
        world.addBoat("a", 0, 0);
        world.startServer("a", "a-boot2");
        boat().commands().submit(path());
        world.run(5);

        assertThat(world.hull("a").isAtRest()).isTrue();
        assertThat(asked()).hasSize(1);
        answer(true);
        assertThat(world.hull("a").isAtRest()).isFalse();
    }

    @Test
    void aBoatThatRanOnWhileTheBaseWasDownIsMovedAtOnce() {
        world = new TestWorld(engine);
        world.addBoat("a", 0, 0);
        boat().commands().submit(path());
        world.run(5);

        assertThat(world.hull("a").isAtRest()).isFalse();
        assertThat(asked()).isEmpty();
    }

    @Test
    void whoeverAllowsTheBoatOtherwiseAnswersTheQuestionAndRemovingItTakesTheQuestionBack() {
        world.startServer("a", "a-boot2");
        world.run(5);
        boat().confirmRestart();
        world.run(1);
        assertThat(asked()).isEmpty();

        world.startServer("a", "a-boot3");
        world.run(5);
        assertThat(asked()).hasSize(1);
        boat().retire("gone");
        world.run(1);
        assertThat(asked()).isEmpty();
    }

    @Test
    void theOperatorIsAskedWhetherAnotherBaseIsToHaveTheBoat() {
        byte[] wish = new LinkCodec().encode(1_000_000, new CommandAsked("other"));
        boat().receive(wish, world.nowMillis());
        world.run(1);

        assertThat(asked()).singleElement().satisfies(decision -> {
            assertThat(decision.prompt()).isEqualTo("other wishes to command a. Is it to have it?");
            assertThat(decision.type()).isEqualTo("CommandAsked");
        });
        answer(true); // the boat knows no such client, and says so

        assertThat(asked()).isEmpty();
        assertThat(world.operator.messages().messages())
                .extracting(OperatorMessage::text)
                .anyMatch(text -> text.startsWith("a refuses: "));
    }

    @Test
    void anAnswerAfterARestartOfTheBaseIsStillAboutTheBaseThatAsked() {
        boat().receive(new LinkCodec().encode(1_000_000, new CommandAsked("other")), world.nowMillis());
        world.run(1);
        world = new TestWorld(engine);
        world.addBoat("a", 0, 0);
        world.run(3);
        List<Decision> asked = world.host.ask(EngineView::decisions);
        assertThat(asked).hasSize(1);

        world.host.post(new Input.AnswerDecision(asked.get(0).id(), new Answer.YesNo(true), Answerer.OPERATOR));
        world.run(2); // the boat knows no such client, and says so

        assertThat(world.operator.messages().messages())
                .extracting(OperatorMessage::text)
                .anyMatch(text -> text.startsWith("a refuses: "));
    }

    @Test
    void aWishThatIsRepeatedAfterARestartOfTheBaseIsAskedAboutOnce() {
        byte[] wish = new LinkCodec().encode(1_000_000, new CommandAsked("other"));
        boat().receive(wish, world.nowMillis());
        world.run(1);
        world = new TestWorld(engine);
        world.addBoat("a", 0, 0);
        world.run(3);

        boat().receive(wish, world.nowMillis());
        world.run(1);

        assertThat(world.host.ask(EngineView::decisions)).hasSize(1);
    }

    @Test
    void theSimulatedOperatorAllowsItUnlessItIsToldOtherwise() {
        world.startServer("a", "a-boot2");
        world.run(5);
        Decision decision = asked().get(0);

        assertThat(simulated("[]").answer(decision, "").result()).isEqualTo(Optional.of(new Answer.YesNo(true)));
        assertThat(simulated("[{\"event\": \"BoatRestarted\", \"answer\": {\"yes\": false}}]")
                        .answer(decision, "")
                        .result())
                .isEqualTo(Optional.of(new Answer.YesNo(false)));
    }

    @Test
    void boatsThatStartedAnewTogetherAreAskedAboutInOneQuestionFromWhichEachCanBeLeftOut() {
        world.addBoat("b", 20, 0);
        world.addBoat("c", 40, 0);
        world.run(3);
        world.startServer("a", "a-boot2");
        world.startServer("b", "b-boot2");
        world.startServer("c", "c-boot2");
        world.run(5);

        assertThat(asked()).singleElement().satisfies(decision -> {
            assertThat(decision.prompt())
                    .isEqualTo("a, b and c have started anew and do not move. Which of them may move again?");
            assertThat(decision.question()).isEqualTo(new Question.ChooseProxies(List.of("a", "b", "c"), 0, 3));
            assertThat(simulated("[]").answer(decision, "").result())
                    .contains(new Answer.Proxies(List.of("a", "b", "c")));
            assertThat(simulated("[{\"event\": \"BoatRestarted\", \"answer\": {\"yes\": false}}]")
                            .answer(decision, "")
                            .result())
                    .contains(new Answer.Proxies(List.of()));
        });
        assertThat(world.operator.decisions().pending().get(0).presentation().boats())
                .containsExactly("a", "b", "c");
        assertThat(world.operator.decisions().pending().get(0).presentation().options())
                .allMatch(OfferedOption::selected);

        world.host.post(new Input.AnswerDecision(
                asked().get(0).id(), new Answer.Proxies(List.of("a", "c")), Answerer.OPERATOR));
        world.run(5);

        assertThat(asked()).isEmpty();
        assertThat(world.boats.find("a").orElseThrow().explain().text()).doesNotContain("nobody has allowed");
        assertThat(world.boats.find("b").orElseThrow().explain().text())
                .contains("nobody has allowed it to move again");
        assertThat(world.boats.find("c").orElseThrow().explain().text()).doesNotContain("nobody has allowed");
    }

    @Test
    void aBoatThatStartsAnewWhileTheQuestionWaitsIsAddedAndOneThatIsGoneIsNotAskedAbout() {
        world.addBoat("b", 20, 0);
        world.run(3);
        world.startServer("a", "a-boot2");
        world.run(5);
        world.startServer("b", "b-boot2");
        world.run(5);

        assertThat(asked())
                .singleElement()
                .satisfies(decision ->
                        assertThat(decision.question()).isEqualTo(new Question.ChooseProxies(List.of("a", "b"), 0, 2)));
        boat().retire("gone");
        world.run(2);

        assertThat(asked())
                .singleElement()
                .satisfies(decision -> assertThat(decision.prompt())
                        .isEqualTo("b has started anew and does not move. May it move again?"));
    }

    private static SimulatedOperator simulated(String rules) {
        String file = "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": " + rules + "}";
        return new SimulatedOperator(
                TestWorld.VOCABULARY,
                new DefaultAnswers(TestWorld.HOME, 100, 0, 1),
                AnswersFileReader.read(file, TestWorld.VOCABULARY).orThrow());
    }
}
