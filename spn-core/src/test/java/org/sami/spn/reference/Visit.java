package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.model.Place;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Token;

/** One entry of tokens, or of nobody, into a place (R-VIS-1). */
final class Visit {
    final long id;
    final Mission mission;
    final Place place;
    final boolean byNobody;
    final List<Activation> activations = new ArrayList<>();
    final List<Instance> instances = new ArrayList<>();
    boolean ended;
    /** When it ended, in order; 0 while it goes on. */
    long endedAs;
    /** Who entered, in order. */
    final List<Token> entered = new ArrayList<>();
    /** A firing that moves sub-mission tokens was enabled by it. */
    boolean used;

    Visit(long id, Mission mission, Place place, boolean byNobody) {
        this.id = id;
        this.mission = mission;
        this.place = place;
        this.byNobody = byNobody;
    }

    /** Whether all its instances are complete (R-SUB-3). */
    boolean complete() {
        return instances.stream().allMatch(i -> i.state == Instance.State.COMPLETE);
    }

    /** Nothing of it runs any longer, but some instance was aborted. */
    boolean aborted() {
        return instances.stream().noneMatch(i -> i.state == Instance.State.RUNNING) && !complete();
    }
}
