package org.sami.crw.gui.decision;

import java.util.List;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandRegistry;

/** What the operator can have done with decisions, each with its key. */
final class DecisionCommands {
    private final Command answer;
    private final Command refuse;
    private final Command draw;
    private final Command later;
    private final Command earlier;
    private final Command nextOption;
    private final Command optionBefore;
    private final Command stopTimer;
    private final Command focus;

    DecisionCommands(CommandRegistry registry, DecisionSteps steps) {
        answer = registry.add(new Command("decision-answer", "Answer", steps::answer)
                .withKey("alt ENTER")
                .withIcon("check")
                .once() // the next decision is shown by then
                .unless(steps::whyNot));
        refuse = registry.add(new Command("decision-refuse", "None of these", steps::refuse)
                .withKey("alt BACK_SPACE")
                .once()
                .unless(steps::whyNotRefuse));
        draw = registry.add(new Command("decision-draw", "Answer on the map", steps::drawOnMap)
                .withKey("alt D")
                .withIcon("map")
                .unless(steps::whyNotDraw));
        later = registry.add(new Command("decision-later", "Next decision", () -> steps.browse(1))
                .withKey("alt DOWN")
                .withIcon("down")
                .unless(steps::whyNotBrowse));
        earlier = registry.add(new Command("decision-earlier", "Decision before", () -> steps.browse(-1))
                .withKey("alt UP")
                .withIcon("up")
                .unless(steps::whyNotBrowse));
        nextOption = registry.add(new Command("decision-option-next", "Next option on the map", () -> steps.look(1))
                .withKey("alt PAGE_DOWN")
                .withIcon("right")
                .unless(steps::whyNotLook));
        optionBefore =
                registry.add(new Command("decision-option-before", "Option before on the map", () -> steps.look(-1))
                        .withKey("alt PAGE_UP")
                        .withIcon("left")
                        .unless(steps::whyNotLook));
        stopTimer = registry.add(new Command("decision-stop-timer", "Stop the timer", steps::stopTimer)
                .withKey("ctrl shift T")
                .withIcon("pause")
                .unless(steps::whyNotStopTimer));
        focus = registry.add(
                new Command("decision-focus", "Go to the decision", steps::focusDecision).withKey("ctrl D"));
    }

    Command answer() {
        return answer;
    }

    Command refuse() {
        return refuse;
    }

    Command draw() {
        return draw;
    }

    Command later() {
        return later;
    }

    Command earlier() {
        return earlier;
    }

    Command stopTimer() {
        return stopTimer;
    }

    /** Asks all again whether they can be run. */
    void refresh() {
        List.of(answer, refuse, draw, later, earlier, nextOption, optionBefore, stopTimer, focus)
                .forEach(Command::refresh);
    }
}
