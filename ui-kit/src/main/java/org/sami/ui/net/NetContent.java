package org.sami.ui.net;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.picture.net.NetMode;
import org.sami.picture.net.NetScene;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What a view shows.
 *
 * @param drawing where the plan's elements lie
 */
record NetContent(Plan plan, Vocabulary vocabulary, NetDrawing drawing) {
    /** A plan without elements. */
    static final NetContent NONE = new NetContent(
            new Plan(
                    "", "", "", List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), Map.of(),
                    List.of(), List.of()),
            new Vocabulary("", List.of(), List.of(), List.of(), List.of()),
            new NetDrawing("", 1, List.of(), List.of(), List.of()));

    NetScene scene(NetMode mode, Set<String> selected) {
        return NetScene.of(plan, drawing, mode, selected);
    }
}
