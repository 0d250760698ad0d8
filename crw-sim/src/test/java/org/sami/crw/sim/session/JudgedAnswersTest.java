package org.sami.crw.sim.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.service.Geodesy;
import org.sami.crw.session.Session;
import org.sami.session.api.DraftAnswer;
import org.sami.session.api.Judgement;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Drafts of answers to questions of plans of the library, in sessions with simulated boats. */
@Timeout(900)
class JudgedAnswersTest {
    @TempDir
    private Path folder;

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(TestSession.PIER, eastM, northM);
    }

    private static GeoArea box(double west, double south, double east, double north) {
        return new GeoArea(List.of(at(west, south), at(west, north), at(east, north), at(east, south)), List.of());
    }

    @Test
    void aDrawnAreaIsJudgedByTheFenceAndByTheBoatsOfTheMission() throws Exception {
        try (TestSession world = new TestSession(folder)) {
            Session session = world.opened(TestSession.library("explore-area"));
            session.begin();
            get(session.fleet().addSimulated("anna", TestSession.PIER, 1));
            Await.until("anna says where it is", () -> hasPosition(session, "anna"));
            get(session.fence().set(box(-100, -100, 500, 500)));
            get(session.start("explore-area", "bay", Map.of()));
            Decision area = decision(session, Question.FillIn.class);

            Judgement judged = judge(session, area, Map.of("area", box(200, 0, 600, 300)));

            assertThat(judged.doubts()).contains("25 % of the area is outside the fence, and boats will be sent there");
            assertThat(judged.costs())
                    .hasSize(2)
                    .anyMatch(words -> words.contains("in lanes 50 m apart"))
                    .anyMatch(words -> words.startsWith("anna: ") && words.contains("of a full charge"));

            get(session.answer(area.id(), new Answer.Fields(Map.of("area", box(200, 0, 400, 300))), "test"));
            Decision boats = decision(session, Question.ChooseProxies.class);
            Judgement chosen =
                    get(session.drafts().judge(boats, new DraftAnswer(Map.of(), List.of("anna"), Optional.empty())));

            assertThat(chosen.costs()).anyMatch(words -> words.startsWith("anna: "));
        }
    }

    @Test
    void numbersAndAddressesThatCannotBeAreRefused() throws Exception {
        try (TestSession world = new TestSession(folder)) {
            Session session = world.opened(TestSession.library("add-simulated-boats"));
            session.begin();
            get(session.start("add-simulated-boats", "more", Map.of()));
            Decision more = decision(session, Question.FillIn.class);

            assertThat(judge(session, more, Map.of("make.numberToCreate", new IntegerValue(99_999)))
                            .refusal())
                    .contains("1 to 250 simulated boats are added at once, not 99,999");

            get(session.abortAll());
            get(session.start("connect-boat-by-address", "one", Map.of()));
            Decision one = decision(session, Question.FillIn.class);

            assertThat(judge(session, one, Map.of("call.server", new TextValue("")))
                            .refusal())
                    .hasValueSatisfying(
                            words -> assertThat(words).startsWith("The address of the boat's server is empty"));
        }
    }

    @Test
    void valuesOfAStartAreJudgedAsAnswersAre() throws Exception {
        try (TestSession world = new TestSession(folder)) {
            Session session = world.opened(TestSession.library("add-simulated-boats"));
            session.begin();

            assertThat(get(session.drafts()
                                    .judgeStart(
                                            "add-simulated-boats",
                                            Map.of("make.numberToCreate", new IntegerValue(99_999))))
                            .refusal())
                    .contains("1 to 250 simulated boats are added at once, not 99,999");
            assertThat(get(session.drafts().judgeStart("add-simulated-boats", Map.of()))
                            .remarks())
                    .isEmpty();
        }
        try (TestSession world = new TestSession(folder)) {
            Session session = world.opened(TestSession.library("explore-area"));
            session.begin();
            get(session.fleet().addSimulated("anna", TestSession.PIER, 1));
            Await.until("anna says where it is", () -> hasPosition(session, "anna"));
            get(session.fence().set(box(-100, -100, 500, 500)));

            Judgement judged = get(session.drafts().judgeStart("explore-area", Map.of("@area", box(200, 0, 600, 300))));

            assertThat(judged.doubts()).anyMatch(words -> words.startsWith("25 % of the area is outside the fence"));
        }
    }

    @Test
    void aGlobalPlaceOutsideTheFenceIsSaidBeforeItIsSet() throws Exception {
        try (TestSession world = new TestSession(folder)) {
            Session session = world.opened(TestSession.library("explore-area"));
            session.begin();
            get(session.fence().set(box(-100, -100, 500, 500)));

            Judgement judged = get(session.drafts().judgeGlobal("@home", at(0, -120)));

            assertThat(judged.doubts()).containsExactly("The place lies 20.0 m outside the fence");
            assertThat(judged.costs()).isEmpty();
        }
    }

    private static Judgement judge(Session session, Decision decision, Map<String, Value> values) throws Exception {
        return get(session.drafts().judge(decision, DraftAnswer.of(values)));
    }

    private static Decision decision(Session session, Class<? extends Question> asking) throws Exception {
        Await.until(
                "it is asked", () -> decisions(session).stream().anyMatch(one -> asking.isInstance(one.question())));
        return decisions(session).stream()
                .filter(one -> asking.isInstance(one.question()))
                .findFirst()
                .orElseThrow();
    }

    private static List<Decision> decisions(Session session) {
        return session.ask(view -> view.decisions()).toCompletableFuture().join();
    }

    private static boolean hasPosition(Session session, String boat) {
        return session.fleet()
                .ask(boats -> boats.find(boat)
                        .filter(one -> one.status().pose().isPresent())
                        .isPresent())
                .toCompletableFuture()
                .join();
    }

    private static <T> T get(CompletionStage<T> stage) throws Exception {
        return stage.toCompletableFuture().get(60, TimeUnit.SECONDS);
    }
}
