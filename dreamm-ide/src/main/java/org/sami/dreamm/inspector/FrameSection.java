package org.sami.dreamm.inspector;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.FrameEdit;
import org.sami.spn.model.FrameColor;
import org.sami.spn.model.NetFrame;
import org.sami.spn.model.Plan;

/** Title and colour of the selected frames. */
final class FrameSection extends Form {
    private final transient DreammContext context;
    private final transient Plan plan;
    private final transient List<Integer> frames;

    FrameSection(DreammContext context, Plan plan, Set<Integer> frames) {
        this.context = context;
        this.plan = plan;
        this.frames = frames.stream().sorted().toList();
        setName("inspector-frame");
        List<NetFrame> now = this.frames.stream().map(plan.frames()::get).toList();
        if (now.size() == 1) {
            text(
                    "Title",
                    "inspector-frame-title",
                    "What the vertices in the frame are for",
                    now.get(0).title(),
                    title -> each(frame -> frame.withTitle(title)));
        }
        choice(
                "Colour",
                "inspector-frame-color",
                "Tells frames apart; it means nothing else",
                List.of(FrameColor.values()),
                VertexSection.common(now, NetFrame::color),
                color -> color.name().toLowerCase(Locale.ROOT),
                color -> each(frame -> frame.withColor(color)));
    }

    private void each(UnaryOperator<NetFrame> change) {
        List<Edit> edits = new ArrayList<>();
        for (int index : frames) {
            edits.add(new FrameEdit.SetFrame(
                    plan.id(), index, change.apply(plan.frames().get(index))));
        }
        context.apply(edits.size() == 1 ? edits.get(0) : new EditSequence("Change frames", edits));
    }
}
