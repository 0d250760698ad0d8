package org.sami.crw.gui.decision;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.LongSupplier;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.picture.ShownPictures;
import org.sami.crw.gui.value.SessionEditors;
import org.sami.session.api.DraftAnswer;
import org.sami.session.api.Judgement;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.component.ComponentLibrary;
import org.sami.spn.component.Interactions;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.ui.value.MapMaker;
import org.sami.ui.value.ValueEditors;

/** The decisions of a session: makes the panel, and keeps it as the queue is. */
public final class SessionDecisions {
    private SessionDecisions() {}

    /**
     * The panel of a session's decisions. On the event thread.
     *
     * @param components that the domain declares
     * @param map where decisions are seen
     * @param maps on which places are drawn
     * @param pictures of the session's boats
     */
    public static DecisionsPanel panel(
            OperatorContext context,
            ComponentLibrary components,
            DecisionMap map,
            MapMaker maps,
            ShownPictures pictures) {
        return panel(context, components, map, maps, pictures, System::currentTimeMillis);
    }

    static DecisionsPanel panel(
            OperatorContext context,
            ComponentLibrary components,
            DecisionMap map,
            MapMaker maps,
            ShownPictures pictures,
            LongSupplier wallMillis) {
        ComponentChoice choice =
                new ComponentChoice(components, context.vocabulary().types());
        ValueEditors editors = SessionEditors.of(context, choice, maps);
        DecisionsPanel panel = new DecisionsPanel(
                context.commands(),
                new Actions(context),
                new Interactions(context.vocabulary()),
                choice,
                editors,
                map,
                pictures,
                context::say,
                wallMillis);
        context.models().decisions().addListener(panel::queue);
        panel.queue(context.models().decisions().snapshot());
        return panel;
    }

    private record Actions(OperatorContext context) implements DecisionActions {
        @Override
        public CompletionStage<Void> answer(long decision, Answer answer) {
            return context.session().answer(decision, answer, OperatorContext.OPERATOR);
        }

        @Override
        public Optional<String> check(long decision, Answer answer) {
            return context.whyNotAct()
                    .or(() -> context.models().decisions().check(decision, answer, context.vocabulary()));
        }

        @Override
        public Optional<String> whyNotAct() {
            return context.whyNotAct();
        }

        @Override
        public CompletionStage<Judgement> judge(Decision decision, DraftAnswer draft) {
            return context.whyNotAct().isPresent()
                    ? CompletableFuture.completedFuture(Judgement.NOTHING)
                    : context.session().drafts().judge(decision, draft);
        }

        @Override
        public void attend(long decision) {
            context.models().decisions().attend(decision);
        }

        @Override
        public CompletionStage<Void> hold(long decision) {
            return context.session().hold(decision);
        }

        @Override
        public long nowMillis() {
            return context.nowMillis();
        }
    }
}
