package org.sami.crw.gui.map;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.gui.decision.DecisionMap;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.Value;
import org.sami.ui.look.IdentityMarks;
import org.sami.ui.map.MapView;
import org.sami.ui.value.PlacesOnMap;

/** What the shown decision speaks of, on the main map: its boats stand out, and what is chosen or filled in is drawn above all else. */
final class DecisionOverlay implements DecisionMap {
    private final MapView view;
    private final PlacesOnMap places;

    DecisionOverlay(MapView view, IdentityMarks marks) {
        this.view = view;
        places = new PlacesOnMap(view, "decision", marks::of);
    }

    @Override
    public void show(DecisionPresentation decision, List<Value> values) {
        places.show(values);
        Set<String> lit = new HashSet<>(places.ids());
        if (decision.question() instanceof Question.ChooseProxies asked) {
            lit.addAll(asked.proxies());
        }
        decision.map().boats().ifPresent(boats -> lit.addAll(boats.boats()));
        view.highlight(lit);
    }

    @Override
    public void clear() {
        places.show(List.of());
        view.highlight(Set.of());
    }
}
