package org.sami.dreamm.learn.show;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.lessons.script.EditScript;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/** Edits are shown one after another by a clock that is given, and can be taken back. */
class ShowMeModelTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final String TWO = """
            {'do': 'add', 'item': 'palette-blank-transition', 'at': [200, 80], 'id': 't', 'say': 'A transition.'},
            {'do': 'connect', 'from': 'a', 'to': 't', 'say': 'And an edge.'}
            """;

    private static ShowMeModel model(String elements) {
        Plan plan = new PlanBuilder("p").start("a").end("b").at("a", 60, 80).build();
        Project project = new Project("x", "", "crw", List.of(), List.of(), List.of(plan));
        return new ShowMeModel(EditScript.read("s.json", "[" + elements.replace('\'', '"') + "]")
                .orThrow()
                .applyTo(project, DOMAIN));
    }

    private static boolean hasTransition(ShowMeModel model) {
        return model.plan().orElseThrow().transition("t").isPresent();
    }

    @Test
    void thePointerGoesToThePaletteThenToTheNetAndThenTheEditIsMade() {
        ShowMeModel model = model(TWO);
        assertThat(model.stop()).isEmpty();

        model.play();
        assertThat(model.stop()).contains(new ShowStop.Item("palette-blank-transition"));
        assertThat(model.sentence()).isEqualTo("A transition.");
        model.tick(ShowMeModel.MOVE_MS / 2.0);
        assertThat(model.way()).isEqualTo(0.5);
        model.tick(ShowMeModel.MOVE_MS / 2.0 + ShowMeModel.REST_MS);
        assertThat(model.stop()).contains(new ShowStop.Spot(new LayoutPoint(200, 80)));
        assertThat(hasTransition(model)).isFalse();

        model.tick(ShowMeModel.MOVE_MS + ShowMeModel.REST_MS);
        assertThat(hasTransition(model)).isTrue();
        assertThat(model.done()).isEqualTo(1);
        assertThat(model.sentence()).isEqualTo("A transition.");
    }

    @Test
    void playedOnItComesToItsEndAndStaysThere() {
        ShowMeModel model = model(TWO);
        List<Integer> heard = new ArrayList<>();
        model.addListener(() -> heard.add(model.done()));

        model.play();
        model.tick(60_000);

        assertThat(model.isAtEnd()).isTrue();
        assertThat(model.isPlaying()).isFalse();
        assertThat(model.isMoving()).isFalse();
        assertThat(model.plan().orElseThrow().inEdges()).hasSize(1);
        assertThat(heard).contains(0, 1, 2);
    }

    @Test
    void twiceAsFastTakesHalfTheTime() {
        ShowMeModel model = model(TWO);
        model.setSpeed(ShowMeModel.Speed.FAST);

        model.play();
        model.tick(ShowMeModel.MOVE_MS + ShowMeModel.REST_MS);

        assertThat(model.done()).isEqualTo(1);
    }

    @Test
    void oneEditAtATimeStaysAfterEach() {
        ShowMeModel model = model(TWO);

        model.forward();
        model.tick(60_000);
        assertThat(model.done()).isEqualTo(1);
        assertThat(model.isMoving()).isFalse();

        model.forward();
        model.forward(); // does not wait for the pointer
        assertThat(model.done()).isEqualTo(2);
    }

    @Test
    void backTakesTheLastEditBack() {
        ShowMeModel model = model(TWO);
        model.forward();
        model.forward();
        assertThat(model.done()).isEqualTo(1);

        model.back();
        assertThat(model.done()).isZero();
        assertThat(hasTransition(model)).isFalse();
        model.back();
        assertThat(model.done()).isZero();
    }

    @Test
    void backWhileThePointerIsOnItsWayForgetsTheWay() {
        ShowMeModel model = model(TWO);
        model.play();
        model.tick(10);

        model.back();

        assertThat(model.isPlaying()).isFalse();
        assertThat(model.stop()).isEmpty();
        assertThat(model.done()).isZero();
    }

    @Test
    void pauseMakesNoEditAndPlayBeginsItAgain() {
        ShowMeModel model = model(TWO);
        model.play();
        model.tick(100);
        model.pause();
        model.tick(60_000);
        assertThat(model.done()).isZero();

        model.play();
        model.tick(60_000);
        assertThat(model.isAtEnd()).isTrue();

        model.play();
        assertThat(model.done()).isZero();
    }

    @Test
    void whatCannotBeDoneIsSaidAtTheEnd() {
        ShowMeModel model = model(TWO + ", {'do': 'rename', 'what': 'nobody', 'name': 'x'}");

        model.play();
        model.tick(60_000);

        assertThat(model.done()).isEqualTo(2);
        assertThat(model.sentence()).startsWith("Element 3 of the script (rename nobody)");
    }
}
