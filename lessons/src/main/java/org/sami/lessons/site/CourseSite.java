package org.sami.lessons.site;

import freemarker.template.Configuration;
import freemarker.template.TemplateException;
import freemarker.template.TemplateExceptionHandler;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.ReadingTime;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Writes a course as a folder of pages that any browser shows without a server or network: texts, pictures as SVG, quizzes that are graded on the page,
 * jobs with their hints and start plans, the glossary.
 */
public final class CourseSite {
    private static final List<String> ASSETS = List.of("course.css", "course.js");

    private final Course course;
    private final Vocabulary vocabulary;
    private final Configuration templates = new Configuration(Configuration.VERSION_2_3_34);

    /** The pages of a course. */
    public CourseSite(Course course, Vocabulary vocabulary) {
        this.course = Objects.requireNonNull(course, "course");
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
        templates.setClassForTemplateLoading(CourseSite.class, "/org/sami/lessons/site");
        templates.setDefaultEncoding("UTF-8");
        templates.setTemplateExceptionHandler(TemplateExceptionHandler.RETHROW_HANDLER);
        templates.setLogTemplateExceptions(false);
    }

    /**
     * Writes all pages; files of theirs that are there already are replaced.
     *
     * @return how many pages
     * @throws IOException if the folder cannot be written
     */
    public int write(Path folder) throws IOException {
        Files.createDirectories(folder.resolve("plans"));
        for (String asset : ASSETS) {
            try (InputStream in = Objects.requireNonNull(CourseSite.class.getResourceAsStream(asset), asset)) {
                Files.write(folder.resolve(asset), in.readAllBytes());
            }
        }
        LessonPages pages = new LessonPages(course, vocabulary);
        List<LessonPage> lessons = course.lessons().stream().map(pages::page).toList();
        for (LessonPage lesson : lessons) {
            Files.writeString(folder.resolve(lesson.id() + ".html"), page("lesson.ftlh", Map.of("lesson", lesson)));
            writeStarts(lesson, folder);
        }
        Files.writeString(
                folder.resolve("index.html"),
                page(
                        "index.ftlh",
                        Map.of("lessons", lessons, "minutes", LessonPages.minutes(ReadingTime.of(course.lessons())))));
        Files.writeString(
                folder.resolve("glossary.html"),
                page(
                        "glossary.ftlh",
                        Map.of(
                                "terms",
                                course.terms().stream()
                                        .sorted(Comparator.comparing(
                                                term -> term.term().toLowerCase(Locale.ROOT)))
                                        .toList())));
        return lessons.size() + 2;
    }

    private void writeStarts(LessonPage lesson, Path folder) throws IOException {
        for (LessonPage.StepPart step : lesson.steps()) {
            Project start = course.plans().get(step.job().key());
            if (start != null) {
                new ProjectWriter(vocabulary)
                        .write(start, folder.resolve(step.job().start()));
            }
        }
    }

    private String page(String template, Map<String, Object> model) throws IOException {
        StringWriter out = new StringWriter();
        try {
            templates.getTemplate(template, StandardCharsets.UTF_8.name()).process(model, out);
        } catch (TemplateException wrong) {
            throw new IllegalStateException("the template " + template + " cannot be filled in", wrong);
        }
        return out.toString();
    }
}
