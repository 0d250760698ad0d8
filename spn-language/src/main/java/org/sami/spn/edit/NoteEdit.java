package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Note;
import org.sami.spn.model.Plan;

/** Changes of the notes of one plan. A note is known by its index in the plan's list. */
public sealed interface NoteEdit extends PlanEdit {
    /** Adds a note behind those that there are. */
    record AddNote(String plan, Note note) implements NoteEdit {
        public AddNote {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(note, "note");
        }

        @Override
        public String label() {
            return "Add note";
        }

        @Override
        public Plan change(Plan before, EditContext context) {
            return before.withNotes(Parts.with(before.notes(), note));
        }
    }

    /** Lets a note say something else. */
    record SetNoteText(String plan, int index, String text) implements NoteEdit {
        public SetNoteText {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(text, "text");
        }

        @Override
        public String label() {
            return "Change note";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            List<Note> notes = new ArrayList<>(before.notes());
            notes.set(checked(before, index), notes.get(index).withText(text));
            return before.withNotes(notes);
        }
    }

    /** Moves notes to other points of the drawing, by their indices. */
    record MoveNotes(String plan, Map<Integer, LayoutPoint> to) implements NoteEdit {
        public MoveNotes {
            Objects.requireNonNull(plan, "plan");
            to = Map.copyOf(new LinkedHashMap<>(to));
        }

        @Override
        public String label() {
            return to.size() == 1 ? "Move note" : "Move " + to.size() + " notes";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            List<Note> notes = new ArrayList<>(before.notes());
            for (Map.Entry<Integer, LayoutPoint> move : to.entrySet()) {
                int index = checked(before, move.getKey());
                notes.set(index, notes.get(index).withAt(Optional.of(move.getValue())));
            }
            return before.withNotes(notes);
        }
    }

    /** Removes notes, by their indices; those behind them move up. */
    record RemoveNotes(String plan, Set<Integer> indices) implements NoteEdit {
        public RemoveNotes {
            Objects.requireNonNull(plan, "plan");
            indices = Set.copyOf(indices);
        }

        @Override
        public String label() {
            return indices.size() == 1 ? "Delete note" : "Delete " + indices.size() + " notes";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            List<Note> notes = new ArrayList<>(before.notes());
            for (int index : new TreeSet<>(indices).descendingSet()) {
                notes.remove(checked(before, index));
            }
            return before.withNotes(notes);
        }
    }

    private static int checked(Plan plan, int index) throws EditRefusedException {
        if (index < 0 || index >= plan.notes().size()) {
            throw new EditRefusedException("The plan \"" + plan.id() + "\" has no note " + (index + 1));
        }
        return index;
    }
}
