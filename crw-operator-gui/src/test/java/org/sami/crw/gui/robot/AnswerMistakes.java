package org.sami.crw.gui.robot;

import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_D;
import static java.awt.event.KeyEvent.VK_DOWN;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_ESCAPE;
import static java.awt.event.KeyEvent.VK_UP;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import javax.swing.AbstractButton;
import org.sami.crw.gui.ReadQuestion;
import org.sami.spn.protocol.Question;

/** What operators do wrong with the answer to a question. */
final class AnswerMistakes {
    private static final List<String> CROSSED =
            List.of("25.3594, 51.5288", "25.3608, 51.5318", "25.3608, 51.5288", "25.3594, 51.5318");
    private static final List<String> IN_NO_GO =
            List.of("25.3574, 51.5264", "25.3574, 51.527", "25.3581, 51.527", "25.3581, 51.5264");
    private static final List<String> FAR_OUT =
            List.of("25.3672, 51.5288", "25.3672, 51.5318", "25.3688, 51.5318", "25.3688, 51.5288");
    private static final List<String> PARTLY_OUT =
            List.of("25.3612, 51.5280", "25.3612, 51.5300", "25.3632, 51.5300", "25.3632, 51.5280");
    private static final List<String> WHOLE_BAY =
            List.of("25.3584, 51.5273", "25.3584, 51.5329", "25.3621, 51.5329", "25.3621, 51.5273");
    private static final List<String> SMALL =
            List.of("25.3596, 51.5276", "25.3599, 51.5276", "25.3599, 51.5280", "25.3596, 51.5280");

    /** The rows. */
    static final List<RobotRow> ROWS = List.of(
            new RobotRow(
                    "An area whose outline crosses itself",
                    "refused in the panel before Answer",
                    world -> refused(world, CROSSED, "The outline crosses itself between points 1 and 3")),
            new RobotRow(
                    "An area wholly outside the fence",
                    "said in the panel before Answer",
                    AnswerMistakes::whollyOutside),
            new RobotRow(
                    "An area partly outside the fence",
                    "the panel says how much of it is outside",
                    AnswerMistakes::partlyOutside),
            new RobotRow(
                    "An area inside a no-go area",
                    "refused in the panel: nothing of it is left",
                    world -> refused(world, IN_NO_GO, "Nothing of the area is left")),
            new RobotRow(
                    "A place in a no-go area",
                    "the panel says how far inside it lies",
                    world -> place(world, "25.3576, 51.5266", "The place lies")),
            new RobotRow(
                    "An empty address for a boat",
                    "refused in the panel before Answer",
                    world -> address(world, "", "The address of the boat's server is empty")),
            new RobotRow(
                    "99,999 simulated boats",
                    "refused in the panel, with how many are possible; no boat is added",
                    AnswerMistakes::manyBoats),
            new RobotRow(
                    "Letters where a number belongs",
                    "said at the field; no answer",
                    AnswerMistakes::lettersForANumber),
            new RobotRow(
                    "More work than all charges last for",
                    "the panel says so before Answer, with the length",
                    AnswerMistakes::moreThanTheCharge),
            new RobotRow(
                    "No boat chosen", "no answer; the panel says that one is to be chosen", AnswerMistakes::noBoat),
            new RobotRow(
                    "Alt+Enter twice",
                    "one answer; the question that comes next is not answered by the second press",
                    AnswerMistakes::answerTwice),
            new RobotRow(
                    "A double click on Answer",
                    "one answer; the question that comes next is not answered by the second click",
                    AnswerMistakes::doubleClickOnAnswer),
            new RobotRow(
                    "Escape in the middle of an area",
                    "the pen is put down; the corners that were given stay; the question stays",
                    AnswerMistakes::escapeInTheMiddle),
            new RobotRow(
                    "Another question looked at in the middle of an answer",
                    "what was filled in is there when the first one is shown again",
                    AnswerMistakes::lookedAtAnother));

    private AnswerMistakes() {}

    private static long draw(RobotWorld world, List<String> corners) throws Exception {
        return draw(world, "explore-team", corners);
    }

    private static long draw(RobotWorld world, String plan, List<String> corners) throws Exception {
        long mission = world.start(plan);
        world.robot.untilShown("value-area-text");
        world.robot.press(VK_D, VK_CONTROL);
        world.robot.untilFocused("value-area-text");
        corners.forEach(corner -> world.robot.type(corner + "\n"));
        return mission;
    }

    private static void answer(RobotWorld world) {
        ReadQuestion.await(world.robot);
        world.robot.press(VK_ENTER, VK_ALT);
    }

    private static boolean asks(RobotWorld world, long mission, Class<? extends Question> kind) {
        return world.decisions().stream()
                .anyMatch(one -> one.decision().mission() == mission
                        && kind.isInstance(one.decision().question()));
    }

    private static void refused(RobotWorld world, List<String> corners, String words) throws Exception {
        long mission = draw(world, corners);
        world.judged(words);
        world.until("there is no answer to press", () -> !world.isOn("decision-answer"));
        answer(world);
        assertThat(asks(world, mission, Question.FillIn.class)).isTrue();
    }

    private static void whollyOutside(RobotWorld world) throws Exception {
        draw(world, FAR_OUT);
        world.judged("The whole area is outside the fence");
    }

    private static void partlyOutside(RobotWorld world) throws Exception {
        draw(world, PARTLY_OUT);
        world.judged("50 % of the area is outside the fence");
    }

    private static void place(RobotWorld world, String typed, String words) throws Exception {
        world.start("deploy-and-station-keep");
        world.robot.untilShown("value-station-text");
        world.type("value-station-text", typed);
        world.judged(words);
    }

    private static void address(RobotWorld world, String typed, String words) throws Exception {
        long mission = world.start("connect-boat-by-address");
        world.robot.untilShown("value-call-server-text");
        world.type("value-call-name-text", "spare");
        world.type("value-call-server-text", typed);
        world.judged(words);
        answer(world);
        assertThat(asks(world, mission, Question.FillIn.class)).isTrue();
        assertThat(world.isOn("decision-answer")).isFalse();
    }

    private static void manyBoats(RobotWorld world) throws Exception {
        int before = world.boats().size();
        long mission = world.start("add-simulated-boats");
        world.robot.untilShown("value-make-number-to-create-text");
        world.type("value-make-start-location-text", "25.3600, 51.5280");
        world.type("value-make-number-to-create-text", "99999");
        world.judged("1 to 250 simulated boats are added at once, not 99,999");
        answer(world);
        assertThat(asks(world, mission, Question.FillIn.class)).isTrue();
        assertThat(world.boats()).hasSize(before);
    }

    private static void lettersForANumber(RobotWorld world) throws Exception {
        world.start("add-simulated-boats");
        world.robot.untilShown("value-make-number-to-create-text");
        world.type("value-make-start-location-text", "25.3600, 51.5280");
        world.type("value-make-number-to-create-text", "two");
        world.says("value-make-number-to-create-message", "number");
        assertThat(world.isOn("decision-answer")).isFalse();
    }

    private static void moreThanTheCharge(RobotWorld world) throws Exception {
        long mission = draw(world, "explore-area", WHOLE_BAY);
        world.judged("in no-go areas"); // what is to be minded has been said, so that one press answers
        answer(world);
        world.until("it asks for boats", () -> asks(world, mission, Question.ChooseProxies.class));
        world.robot.click("value-decision-none-chosen");
        world.robot.click("value-decision-option-1");
        world.judged("sure to last for");
    }

    private static void noBoat(RobotWorld world) throws Exception {
        long mission = world.start("clv");
        world.robot.click("value-decision-none-chosen");
        answer(world);
        world.judged("hoose");
        assertThat(asks(world, mission, Question.ChooseProxies.class)).isTrue();
    }

    private static void answerTwice(RobotWorld world) throws Exception {
        long mission = draw(world, SMALL);
        world.until("it can be answered", () -> world.isOn("decision-answer"));
        ReadQuestion.await(world.robot);
        world.robot.pressTwice(VK_ENTER, VK_ALT);
        world.until("it asks for boats", () -> asks(world, mission, Question.ChooseProxies.class));
        world.says("value-decision-count", "5 of 5 chosen");
        untilFirmly(world, mission);
    }

    private static void doubleClickOnAnswer(RobotWorld world) throws Exception {
        long mission = draw(world, SMALL);
        world.until("it can be answered", () -> world.isOn("decision-answer"));
        AbstractButton button = world.robot.find(AbstractButton.class, "decision-answer");
        ReadQuestion.await(world.robot);
        world.robot.doubleClickAt(button, 12, 12);
        world.until("it asks for boats", () -> asks(world, mission, Question.ChooseProxies.class));
        world.says("value-decision-count", "5 of 5 chosen");
        untilFirmly(world, mission);
    }

    /** The question for boats stays: a second press is handled in order, before a third thing is seen to be done. */
    private static void untilFirmly(RobotWorld world, long mission) throws Exception {
        RobotWorld.get(world.session().ask(view -> view.missions().size()));
        assertThat(asks(world, mission, Question.ChooseProxies.class)).isTrue();
        assertThat(world.boats()).allMatch(boat -> boat.points() == 0);
    }

    private static void escapeInTheMiddle(RobotWorld world) throws Exception {
        long mission = draw(world, SMALL.subList(0, 3));
        world.robot.press(VK_ESCAPE);
        world.robot.press(VK_ESCAPE);
        assertThat(asks(world, mission, Question.FillIn.class)).isTrue();
        assertThat(world.text("value-area-text").lines().filter(line -> !line.isBlank()))
                .hasSize(3);
    }

    private static void lookedAtAnother(RobotWorld world) throws Exception {
        draw(world, SMALL);
        world.start("clv");
        world.robot.press(VK_DOWN, VK_ALT);
        world.robot.untilShown("value-decision-count");
        world.robot.press(VK_UP, VK_ALT);
        world.robot.untilShown("value-area-text");
        assertThat(world.text("value-area-text").lines().filter(line -> !line.isBlank()))
                .hasSize(4);
    }
}
