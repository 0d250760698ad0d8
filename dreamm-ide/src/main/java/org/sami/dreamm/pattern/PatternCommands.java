package org.sami.dreamm.pattern;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.dreamm.compare.PlanComparison;
import org.sami.dreamm.context.AuthorQuestion;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.EditorListener;
import org.sami.dreamm.wizard.Additions;
import org.sami.spn.edit.Edit;
import org.sami.spn.model.Plan;
import org.sami.spn.pattern.Pattern;
import org.sami.spn.pattern.PatternSpot;
import org.sami.spn.pattern.Patterns;
import org.sami.spn.wizard.PlanChange;
import org.sami.ui.command.Command;

/**
 * One command for each pattern. It shows on the net what would be drawn and asks; Enter draws it, Escape leaves it. The preview goes when the
 * plan or the selection becomes another.
 */
public final class PatternCommands {
    private static final String QUESTION = "pattern";

    private final DreammContext context;

    private PatternCommands(DreammContext context) {
        this.context = Objects.requireNonNull(context, "context");
    }

    /** Adds the commands of a window. */
    public static void addTo(DreammContext context) {
        PatternCommands patterns = new PatternCommands(context);
        int key = 1;
        for (Pattern pattern : Patterns.of(context.additions().library())) {
            Command command = context.commands()
                    .add(new Command("pattern-" + pattern.id(), pattern.title() + "…", () -> patterns.preview(pattern))
                            .unless(() -> patterns.whyNot(pattern)));
            if (key <= 9) {
                command.withKey("alt shift " + key++);
            }
        }
        context.document().addListener(change -> patterns.end());
        context.editor().addListener(new EditorListener() {
            @Override
            public void planOpened() {
                patterns.end();
            }

            @Override
            public void selectionChanged() {
                patterns.end();
            }
        });
    }

    private Optional<String> whyNot(Pattern pattern) {
        return context.editor()
                .plan()
                .map(plan ->
                        context.profile().whyLocked("pattern-" + pattern.id()).or(() -> pattern.refusal(spot(plan))))
                .orElse(Optional.of("no plan is open"));
    }

    private PatternSpot spot(Plan plan) {
        return new PatternSpot(
                context.document().project(),
                plan,
                context.editor().selection(),
                context.additions().mode(),
                context.vocabulary(),
                context.additions().library());
    }

    private void preview(Pattern pattern) {
        Plan plan = context.editor().plan().orElseThrow();
        Edit edit = pattern.edit(spot(plan));
        Additions.Preview preview = context.additions().preview(edit);
        if (preview.refusal().isPresent()) {
            context.notices().refused(preview.refusal().get());
            return;
        }
        context.preview()
                .show(
                        preview.planned().orElseThrow(),
                        PlanComparison.of(plan, preview.planned().orElseThrow(), context.vocabulary())
                                .changes());
        context.questions()
                .ask(new AuthorQuestion(
                        QUESTION,
                        pattern.title() + ": "
                                + preview.change().map(PlanChange::summary).orElse(""),
                        List.of(
                                new AuthorQuestion.Choice("pattern-draw", "Draw it", () -> draw(edit)),
                                new AuthorQuestion.Choice("pattern-leave", "Leave it", this::end)),
                        this::end));
    }

    private void draw(Edit edit) {
        context.preview().clear();
        context.additions().add(edit);
    }

    private void end() {
        context.preview().clear();
        context.questions().withdraw(QUESTION);
    }
}
