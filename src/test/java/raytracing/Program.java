package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * The finished jar in a process of its own, as users run it.
 *
 * @param status exit status
 * @param output what it wrote to standard output
 * @param errors what it wrote to standard error
 */
record Program(int status, String output, String errors) {
    static final Path JAR = Path.of(System.getProperty("raytracing.jar", "build/libs/RayTracer.jar"));
    static final Path JAVA_HOME = Path.of(System.getProperty("java.home"));

    static Program run(Path folder, String... arguments) throws IOException, InterruptedException {
        return run(JAVA_HOME, List.of(), folder, arguments);
    }

    static Program run(Path javaHome, List<String> javaOptions, Path folder, String... arguments)
            throws IOException, InterruptedException {
        return run(javaHome, javaOptions, Map.of(), folder, arguments);
    }

    /** Of the environment, some variables have other values, or none where the value is empty. */
    static Program run(Path javaHome, List<String> javaOptions, Map<String, String> environment, Path folder,
                       String... arguments) throws IOException, InterruptedException {
        Path output = Files.createTempFile("output", "");
        Path errors = Files.createTempFile("errors", "");
        try {
            Process process = start(List.of(), javaHome, javaOptions, environment, folder, output, errors, arguments);
            return new Program(Patience.awaitEnd(process), Files.readString(output), Files.readString(errors));
        } finally {
            Files.delete(output);
            Files.delete(errors);
        }
    }

    static Process start(Path javaHome, List<String> javaOptions, Path folder, Path output, Path errors,
                         String... arguments) throws IOException {
        return start(List.of(), javaHome, javaOptions, Map.of(), folder, output, errors, arguments);
    }

    /**
     * Starts it through another command, which takes it as its last words, if that has some words; of the environment,
     * some variables have other values, or none where the value is empty.
     */
    static Process start(List<String> through, Path javaHome, List<String> javaOptions, Map<String, String> environment,
                         Path folder, Path output, Path errors, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(through);
        command.add(javaHome.resolve("bin/java").toString());
        command.addAll(javaOptions);
        command.addAll(List.of("-jar", JAR.toAbsolutePath().toString()));
        command.addAll(List.of(arguments));
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile())
            .redirectOutput(output.toFile()).redirectError(errors.toFile());
        environment.forEach(builder.environment()::put);
        builder.environment().values().removeIf(String::isEmpty);
        builder.environment().remove("JAVA_TOOL_OPTIONS");   // announces itself on standard error
        return builder.start();
    }
}
