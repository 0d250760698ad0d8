package org.sami.crw.gui.boat;

import java.util.Optional;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.alarm.LaunchCheck;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.explanation.LostLinkWords;
import org.sami.session.api.RefusedException;
import org.sami.ui.command.Command;

/** Sets what the selected boat does when its link is lost to what the session wishes, and says whether the boat has it then. On the event thread. */
final class LostLinkSetting {
    private final OperatorContext context;
    private final Command command;

    LostLinkSetting(OperatorContext context) {
        this.context = context;
        command = context.commands()
                .add(new Command("boat-set-wished-lost-link", "Set what is wished without a link", this::set)
                        .withIcon("check")
                        .unless(() -> context.whyNotAct().or(this::whyNot).map(context::say)));
        context.boats().addListener(command::refresh);
    }

    Command command() {
        return command;
    }

    private Optional<BoatSnapshot> selected() {
        return context.boats().boats().size() == 1
                ? context.models().fleet().boat(context.boats().boats().get(0))
                : Optional.empty();
    }

    private Optional<String> whyNot() {
        Optional<LostLinkAction> wish = context.lostLinkWish();
        if (wish.isEmpty()) {
            return Optional.of("this session wishes nothing: see Settings, Wished without a link");
        }
        return selected()
                .map(boat -> LaunchCheck.isAgainstWish(boat, wish)
                        ? Optional.<String>empty()
                        : Optional.of(
                                boat.settings().isPresent()
                                        ? "it does what is wished"
                                        : "it has not said what it does without a link"))
                .orElse(Optional.of("select one boat first"));
    }

    private void set() {
        String boat = selected().orElseThrow().boat();
        LostLinkAction wish = context.lostLinkWish().orElseThrow();
        String words = "without a link " + boat + " " + LostLinkWords.of(wish);
        context.session().fleet().setLostLinkAction(boat, wish).whenComplete((taken, fault) -> {
            if (fault == null) {
                context.notices().show(words + ", as it has confirmed");
            } else {
                context.notices().refused(boat + " is not set: " + RefusedException.reason(fault));
            }
            command.refresh();
        });
    }
}
