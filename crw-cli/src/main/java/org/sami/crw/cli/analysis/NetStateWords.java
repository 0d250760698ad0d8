package org.sami.crw.cli.analysis;

import java.util.List;
import java.util.stream.IntStream;
import org.sami.petri.net.PetriNet;
import org.sami.spn.planspace.StateWords;

/** The words for states and firings of a net of a file: names of its places and transitions. */
record NetStateWords(PetriNet net) implements StateWords {
    @Override
    public List<String> marked(int[] marking) {
        return IntStream.range(0, marking.length)
                .filter(place -> marking[place] > 0)
                .mapToObj(place -> net.placeName(place) + (marking[place] == 1 ? "" : "*" + marking[place]))
                .toList();
    }

    @Override
    public String firing(int transition) {
        return net.transitionName(transition);
    }

    @Override
    public boolean isEnd(int[] marking) {
        return false;
    }
}
