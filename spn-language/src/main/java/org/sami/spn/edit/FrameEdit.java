package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.NetFrame;
import org.sami.spn.model.Plan;

/** Changes of the frames of one plan. A frame is known by its index in the plan's list. */
public sealed interface FrameEdit extends PlanEdit {
    /** Adds a frame behind those that there are. */
    record AddFrame(String plan, NetFrame frame) implements FrameEdit {
        public AddFrame {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(frame, "frame");
        }

        @Override
        public String label() {
            return "Add frame";
        }

        @Override
        public Plan change(Plan before, EditContext context) {
            return before.withFrames(Parts.with(before.frames(), frame));
        }
    }

    /** Gives a frame another title, colour, place or size. */
    record SetFrame(String plan, int index, NetFrame frame) implements FrameEdit {
        public SetFrame {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(frame, "frame");
        }

        @Override
        public String label() {
            return "Change frame";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            List<NetFrame> frames = new ArrayList<>(before.frames());
            frames.set(checked(before, index), frame);
            return before.withFrames(frames);
        }
    }

    /** Moves frames to other points of the drawing, by their indices; what lies in them stays. */
    record MoveFrames(String plan, Map<Integer, LayoutPoint> to) implements FrameEdit {
        public MoveFrames {
            Objects.requireNonNull(plan, "plan");
            to = Map.copyOf(new LinkedHashMap<>(to));
        }

        @Override
        public String label() {
            return to.size() == 1 ? "Move frame" : "Move " + to.size() + " frames";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            List<NetFrame> frames = new ArrayList<>(before.frames());
            for (Map.Entry<Integer, LayoutPoint> move : to.entrySet()) {
                int index = checked(before, move.getKey());
                frames.set(index, frames.get(index).withAt(move.getValue()));
            }
            return before.withFrames(frames);
        }
    }

    /** Removes frames, by their indices; those behind them move up. What lies in them stays. */
    record RemoveFrames(String plan, Set<Integer> indices) implements FrameEdit {
        public RemoveFrames {
            Objects.requireNonNull(plan, "plan");
            indices = Set.copyOf(indices);
        }

        @Override
        public String label() {
            return indices.size() == 1 ? "Delete frame" : "Delete " + indices.size() + " frames";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            List<NetFrame> frames = new ArrayList<>(before.frames());
            for (int index : new TreeSet<>(indices).descendingSet()) {
                frames.remove(checked(before, index));
            }
            return before.withFrames(frames);
        }
    }

    private static int checked(Plan plan, int index) throws EditRefusedException {
        if (index < 0 || index >= plan.frames().size()) {
            throw new EditRefusedException("The plan \"" + plan.id() + "\" has no frame " + (index + 1));
        }
        return index;
    }
}
