package org.sami.dreamm.learn.view;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import org.sami.dreamm.learn.LessonModel;
import org.sami.dreamm.learn.view.EntryCell.Entry;
import org.sami.lessons.course.Course.StepAddress;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.Step;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;

/** The contents of the course: lessons and the steps of the one that is taken, with what is done. Enter or a click goes there. */
final class ContentsView extends JPanel {
    private static final int WIDTH = 460;
    private static final int HEIGHT = 560;
    private static final int ICON = 16;

    private final transient LessonModel model;
    private final JList<Line> list;

    /** A lesson, or a step of one. */
    private record Line(Lesson lesson, Optional<Step> step) {}

    ContentsView(LessonModel model, Runnable close) {
        super(new BorderLayout());
        this.model = model;
        List<Line> lines = new ArrayList<>();
        for (Lesson lesson : model.course().lessons()) {
            lines.add(new Line(lesson, Optional.empty()));
            if (lesson.id().equals(model.lesson().id())) {
                lesson.steps().forEach(step -> lines.add(new Line(lesson, Optional.of(step))));
            }
        }
        list = new JList<>(lines.toArray(Line[]::new)) {
            @Override
            public boolean getScrollableTracksViewportWidth() {
                return true; // titles are shortened, not scrolled
            }
        };
        list.setName("learn-contents-list");
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setCellRenderer(new EntryCell<>(this::entry));
        list.getAccessibleContext().setAccessibleName("Lessons and steps");
        LookColors.background(list, SemanticColor.SURFACE);
        int now = lines.indexOf(new Line(model.lesson(), Optional.of(model.step())));
        list.setSelectedIndex(now);
        list.ensureIndexIsVisible(now);
        list.getInputMap().put(KeyStroke.getKeyStroke("ENTER"), "go");
        list.getActionMap().put("go", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                go(close);
            }
        });
        list.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent e) {
                go(close);
            }
        });
        JScrollPane scroll = new JScrollPane(list);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.setHorizontalScrollBarPolicy(JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        add(scroll);
        setPreferredSize(new Dimension(Look.px(WIDTH), Look.px(HEIGHT)));
    }

    private Entry entry(Line line) {
        if (line.step().isPresent()) {
            Step step = line.step().get();
            boolean done = model.isDone(new StepAddress(line.lesson().id(), step.id()));
            return new Entry(
                    step.title(),
                    kind(step) + (done ? " · done" : ""),
                    done ? Icons.of("check", ICON, SemanticColor.OK) : Icons.of(icon(step), ICON, SemanticColor.MUTED),
                    false);
        }
        Lesson lesson = line.lesson();
        int done = model.done(lesson);
        boolean all = done == lesson.steps().size();
        return new Entry(
                lesson.heading(),
                done + " of " + lesson.steps().size() + " steps done. " + lesson.summary(),
                all ? Icons.of("check", ICON, SemanticColor.OK) : Icons.of("layers", ICON, SemanticColor.TEXT),
                true);
    }

    private static String kind(Step step) {
        if (step instanceof Step.Quiz quiz) {
            return quiz.review() ? "Review question" : "QuizQuestion";
        } else if (step instanceof Step.Job) {
            return "Job";
        } else if (step instanceof Step.Play) {
            return "Play it";
        }
        return step instanceof Step.Show ? "Show me" : "Read";
    }

    private static String icon(Step step) {
        if (step instanceof Step.Quiz) {
            return "help";
        } else if (step instanceof Step.Job) {
            return "edit";
        }
        return step instanceof Step.Play || step instanceof Step.Show ? "play" : "file";
    }

    private void go(Runnable close) {
        Line line = list.getSelectedValue();
        if (line != null) {
            close.run();
            Optional<Step> step = line.step()
                    .or(() -> line.lesson().steps().stream()
                            .filter(each ->
                                    !model.isDone(new StepAddress(line.lesson().id(), each.id())))
                            .findFirst()
                            .or(() -> line.lesson().steps().stream().findFirst()));
            step.ifPresent(to -> model.go(new StepAddress(line.lesson().id(), to.id())));
        }
    }
}
