package org.sami.crw.operator;

import java.util.List;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.picture.TakenPictures;
import org.sami.spn.engine.EngineView;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Tells models what happened once, at any speed and again from the start. Steps of the engine go to {@link OperatorModels#onPastStep}. For one
 * thread of the replay's, which never waits for the models' owner.
 */
public final class ReplayFeed {
    private final OperatorModels models;

    ReplayFeed(OperatorModels models) {
        this.models = models;
    }

    /**
     * Starts again: forgets what happened, and shows what a session shows at its start. What the person who watches chose to see, such as layers
     * of the map, stays.
     *
     * @param start a state without missions
     */
    public void begin(EngineView start) {
        models.forget(start);
        models.restoreAreas(start);
        models.restore(start, 0);
    }

    /** Listeners get nothing until {@link #release}, so that a jump does not flicker. */
    public void hold() {
        models.hold(true);
    }

    /** Tells listeners what is so now. */
    public void release() {
        models.hold(false);
    }

    /** Shows what the engine's state says when it is asked: what blocks missions, which buttons there are. */
    public void look(EngineView view, Vocabulary vocabulary) {
        models.look(view, vocabulary);
    }

    /** A boat was known as this. */
    public void seen(BoatSnapshot boat) {
        models.post(() -> models.fleet().show(boat));
    }

    /** A boat has not changed; only the ages of its values have. */
    public void stillSeen(BoatSnapshot boat) {
        models.post(() -> models.stillSeen(boat));
    }

    /** A boat was gone. */
    public void gone(String boat) {
        models.post(() -> models.fleet().remove(boat));
    }

    /** Something happened to a boat's commands, or a boat measured. */
    public void happened(FleetEvent event, long atMillis) {
        if (event instanceof FleetEvent.Measured measured) {
            models.map().measured(measured);
        } else if (TakenPictures.concerns(event)) {
            models.post(() -> models.pictures().apply(event, atMillis));
        } else if (CommandModel.concerns(event)) {
            models.post(() -> {
                models.commands().apply(event, atMillis);
                models.map().refresh();
            });
        }
    }

    /** The operator did something, as it was logged. */
    public void logged(List<OperatorLogEntry> entries) {
        models.log().restore(entries);
    }

    /** Runs work on the models' owner's thread, after earlier events: the clock of ages goes on. */
    public void then(Runnable change) {
        models.post(change);
    }

    /** So much time has passed: what waits for its time on the map is due. */
    public void tick(long nowMillis) {
        models.post(() -> models.map().tick(nowMillis));
    }

    /** Draws what was measured. */
    public void draw(long nowMillis) {
        models.map().look(nowMillis);
    }
}
